#pragma once

#include <array>
#include <string_view>

// Files of other programs, made by hand after their documentation.

namespace zeroset::test {

/// SURFER: a torus with a slider, seen from above, in a ball of radius 10^0.5.
inline constexpr std::string_view jsurf_torus = R"(#jSurfer surface description
surface_equation=(x^2+y^2+z^2+a^2-b^2)^2-4*a^2*(x^2+y^2)
surface_parameter_a=0.75
surface_parameter_b=0.25
scale_factor=0.5
camera_type=ORTHOGRAPHIC_CAMERA
camera_height=2.0
camera_transform=1.0 0.0 0.0 0.0  0.0 1.0 0.0 0.0  0.0 0.0 1.0 -1.0  0.0 0.0 0.0 1.0
rotation_matrix=1 0 0 0  0 0 1 0  0 -1 0 0  0 0 0 1
front_material_color=1.0 0.5 0.0
back_material_color=1.0 0.5 0.0
background_color=1.0 1.0 1.0
front_material_shininess=30
light_status_0=ON
light_position_0=-100 100 100
light_intensity_0=0.5
light_color_0=1 1 1
)";

/// surf: -x^2 is (-x)^2 there, and a scale of 1/2 makes the surface twice as large.
inline constexpr std::string_view surf_ball = R"(// a ball
double Pi = 2*arccos(0);
poly q = -x^2 + y^2;   // x^2 + y^2
poly s = rotate(q - 1, Pi/2, xAxis);
scale_x = 1/2; scale_y = 1/2; scale_z = 1/2;
radius = 5;
surface_red = 255; surface_green = 0; surface_blue = 0;
inside_red = 255; inside_green = 0; inside_blue = 0;
smoothness = 50;
surface = q + z^2 - 3^2;
surface2 = s;
clear_screen;
draw_surface;
)";

inline constexpr std::string_view mathmod_model = R"js({"MathModels": [
 {"Iso3D": {"Name": ["Two parts"], "Component": ["a", "b"],
   "Const": ["N=2", "r=0DOTSYMBOL5"],
   "Funct": ["Ball=x^2+y^2+z^2-r^2", "Shift=Ball(x-N*r,y,z,t)"],
   "Fxyz": ["Ball(x,y,z,t)", "Shift(x,y,z,t)*if(x>0 & y%2<1, 1, 2)"],
   "Cnd": ["z>0", ""],
   "Xmin": ["-N"], "Xmax": ["N"], "Ymin": ["-pi"], "Ymax": ["pi"], "Zmin": ["-1"], "Zmax": ["1"]},
  "Sliders": {"Name": ["N"], "Min": ["1"], "Max": ["9"], "Step": ["1"], "Position": ["3"]},
  "Texture": {"Colors": ["R=1"]}},
 {"Param3D": {"Name": ["Helicoid"], "Component": ["h"],
   "Fx": ["u*cos(v)"], "Fy": ["u*sin(v)"], "Fz": ["v"],
   "Umin": ["0"], "Umax": ["1"], "Vmin": ["0"], "Vmax": ["2*pi"]}},
 {"Iso3D": {"Name": ["Waves"], "Component": ["w"], "Varu": ["C=cos(u)"],
   "Fxyz": ["Cx + Cy + Cz"],
   "Xmin": ["-4"], "Xmax": ["4"], "Ymin": ["-4"], "Ymax": ["4"], "Zmin": ["-4"], "Zmax": ["4"]}}
]})js";

inline constexpr std::string_view k3ds_equations = R"(/* two equations */
Name: Chair
F(): (x^2+y^2+z^2-0.95*25)^2
 - 0.8*((z-5)^2-2*x^2)*((z+5)^2-2*y^2)
[x]: -5 , 5
[y]: -5 , 5
[z]: -5 , 5
;
Name: Cut ball
F(): x*x + y*y + z*z - t - 1
Cnd: x > 0
[x]: -2 , 2
[y]: -2 , max(1, 2)
[z]: -2 , 2
;
)";

inline constexpr std::string_view instruction_list = R"(# a ball
_0 var-x
_1 square _0
_2 var-y
_3 square _2
_4 add _1 _3
_5 var-z
_6 square _5
_7 add _4 _6
_8 const 0.25
_9 sub _7 _8
)";

inline constexpr std::string_view impvis_presets = R"(title = "Presets"

[steiner]
name = "Roman"
bounds_radius = 1.5
dvr_falloff = 0.5
parameters = [{name = "k", value = 2},
              {name = "m", value = 0.5}]
code_global = '''
float sq(float u) { float v = u*u; return v; }
'''
expression = '''
sq(x*y)+sq(y*z)+sq(z*x)
-k*x*y*z'''

[cube]
bounds_shape = "box"
bounds_radius = 2.0
expression = "mpow4(x)+mpow4(y)+mpow4(z)-m"
parameters = [{name = "m", value = 0.5}]
)";

/// POV-Ray: a closed cylinder that a loop places twice, and an open one of a declared function.
inline constexpr std::string_view pov_scene = R"(#version 3.7;
#include "functions.inc"
#declare R = 0.5;
#declare F = function(x, y, z, a) { sqr(x) + sqr(z) - a*log(100)/2 }
#declare Red_one = texture { pigment { color rgb <1, 0, 0> } }
camera { location <0, 0, -10> look_at <0, 0, 0> angle 40 }
light_source { <1, 2, 3> color rgb 1 }
#declare i = 0;
#while (i < 2)
  isosurface {
    function { sqrt(x*x + z*z) - R }
    contained_by { box { <-1, -1, -1>, <1, 1, 1> } }
    threshold 0.25
    texture { Red_one }
    translate <3*i, 0, 0>
  }
  #declare i = i + 1;
#end
#if (R > 1)
  isosurface { function { x } }
#else
  union {
    isosurface {
      function { F(x, y, z, mod(-3, 2) + 2) }
      contained_by { sphere { <0, 0, 0>, 2 } }
      open
      pigment { rgbt <0, 0, 1, 0.25> }
      rotate <90, 0, 0>
    }
    translate <0, 5, 1>
  }
#end
sphere { 0, 1 }
)";

/// POV-Ray: arrays, declared containers, an inverse transform and a right-handed camera.
inline constexpr std::string_view pov_arrays =
    R"(#declare A = array[2][2] { { 1, <2, 3, 4> }, { 5 } }
#declare A[1][1] = A[0][1].y + dimension_size(A, 2);
#declare Shell = sphere { <0, 0, 0>, -2 }
#declare Turn = transform { rotate <90, 0, 0> translate x }
camera { location <0, 0, -9> look_at 0 right -x*4/3 }
#declare Ball = isosurface {
  function { x*x + y*y + z*z - A[0][0] #for (I, 0, 1) + 0*A[I][1].x #end }
  contained_by { Shell }
  transform { Turn inverse }
}
)";

/// surf: a surface that goes on from itself.
inline constexpr std::string_view surf_turned = R"(surface = x^2 + y^2 - z^2;
surface = rotate(surface, 1.2, xAxis); surface2 = surface - rotate(surface, Pi/2, yAxis);
draw_surface;
)";

struct Sample {
    std::string_view file;
    std::string_view bytes;
};
inline constexpr std::array samples{
    Sample{"torus.jsurf", jsurf_torus},  Sample{"ball.pic", surf_ball},
    Sample{"models.js", mathmod_model},  Sample{"chair.k3ds", k3ds_equations},
    Sample{"ball.vm", instruction_list}, Sample{"presets.toml", impvis_presets},
    Sample{"scene.pov", pov_scene},      Sample{"arrays.pov", pov_arrays},
    Sample{"turned.pic", surf_turned}};

}  // namespace zeroset::test
