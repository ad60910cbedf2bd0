#!/usr/bin/env python3
"""Writes small files of the kinds that Zeroset reads but does not write, to be changed by file_fuzz.

Usage: make_files.py FOLDER
"""

import gzip
import json
import struct
import sys
from pathlib import Path

SIDE = 4
SAMPLES = bytes((x * y + z) % 251 for z in range(SIDE) for y in range(SIDE) for x in range(SIDE))


def meta_image():
    head = (f"ObjectType = Image\nNDims = 3\nDimSize = {SIDE} {SIDE} {SIDE}\n"
            "ElementSpacing = 1 2 0.5\nOffset = -1 0 1\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
            "ElementByteOrderMSB = False\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n")
    return head.encode() + SAMPLES


def nifti():
    head = bytearray(348)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, SIDE, SIDE, SIDE, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 2, 8)
    struct.pack_into("<8f", head, 76, 1, 1, 1, 2, 1, 1, 1, 1)
    struct.pack_into("<3f", head, 108, 352, 1, 0)
    struct.pack_into("<2h", head, 252, 1, 1)
    struct.pack_into("<12f", head, 280, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0)
    head[344:348] = b"n+1\0"
    return bytes(head) + bytes(4) + SAMPLES


def vtk_image():
    values = " ".join(str(sample) for sample in SAMPLES)
    end = SIDE - 1
    return (f'<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" '
            'byte_order="LittleEndian" header_type="UInt64">\n'
            f'<ImageData WholeExtent="0 {end} 0 {end} 0 {end}" Origin="0 0 0" Spacing="1 1 1">\n'
            f'<Piece Extent="0 {end} 0 {end} 0 {end}"><PointData Scalars="v">\n'
            f'<DataArray type="UInt8" Name="v" format="ascii">{values}</DataArray>\n'
            '</PointData></Piece></ImageData></VTKFile>\n').encode()


def dicom():
    def element(group, number, kind, value):
        if len(value) % 2:
            value += b"\0" if kind in (b"UI", b"OB") else b" "
        long = kind in (b"OB", b"OW")
        length = struct.pack("<HI", 0, len(value)) if long else struct.pack("<H", len(value))
        return struct.pack("<HH", group, number) + kind + length + value

    def short(number):
        return struct.pack("<H", number)
    meta = element(2, 0x10, b"UI", b"1.2.840.10008.1.2.1")
    data = b"".join([
        element(8, 0x18, b"UI", b"1.2.3.4"), element(0x20, 0x0e, b"UI", b"1.2.3"),
        element(0x20, 0x32, b"DS", b"0\\0\\1.5"), element(0x20, 0x37, b"DS", b"1\\0\\0\\0\\1\\0"),
        element(0x28, 2, b"US", short(1)), element(0x28, 4, b"CS", b"MONOCHROME2"),
        element(0x28, 0x10, b"US", short(SIDE)), element(0x28, 0x11, b"US", short(SIDE)),
        element(0x28, 0x30, b"DS", b"0.5\\0.5"), element(0x28, 0x100, b"US", short(8)),
        element(0x28, 0x101, b"US", short(8)), element(0x28, 0x102, b"US", short(7)),
        element(0x28, 0x103, b"US", short(0)),
        element(0x7fe0, 0x10, b"OB", SAMPLES[:SIDE * SIDE])])
    head = element(2, 0, b"UL", struct.pack("<I", len(meta)))
    return bytes(128) + b"DICM" + head + meta + data


def mgh():
    head = bytearray(284)
    struct.pack_into(">7i", head, 0, 1, SIDE, SIDE, SIDE, 1, 0, 0)
    struct.pack_into(">h15f", head, 28, 1, 1, 1, 2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 6, 7)
    return bytes(head) + SAMPLES


def mrc():
    head = bytearray(1024)
    struct.pack_into("<10i", head, 0, SIDE, SIDE, SIDE, 0, 0, 0, 0, SIDE, SIDE, SIDE)
    struct.pack_into("<6f3i", head, 40, 4, 5, 6, 90, 100, 90, 1, 2, 3)
    head[208:216] = b"MAP DD\0\0"
    return bytes(head) + SAMPLES


def vtk_legacy():
    return (f"# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET STRUCTURED_POINTS\n"
            f"DIMENSIONS {SIDE} {SIDE} {SIDE}\nSPACING 1 2 3\nORIGIN 0 0 0\n"
            f"POINT_DATA {SIDE ** 3}\nSCALARS v unsigned_char 1\nLOOKUP_TABLE default\n"
            ).encode() + SAMPLES


def tiff_stack():
    data, link = bytearray(b"II*\0\0\0\0\0"), 4
    for page in range(SIDE):
        at = len(data)
        data += SAMPLES[page * SIDE * SIDE:(page + 1) * SIDE * SIDE]
        struct.pack_into("<I", data, link, len(data))
        tags = [(256, SIDE), (257, SIDE), (258, 8), (259, 1), (273, at), (277, 1),
                (279, SIDE * SIDE), (339, 1)]
        data += struct.pack("<H", len(tags))
        for tag, value in tags:
            data += struct.pack("<HHII", tag, 4, 1, value)
        link = len(data)
        data += bytes(4)
    return bytes(data)


TEXTS = {
    "points.xyz": "2\nwater\nO 0 0 0\nH 1 0 0.5\n",
    "sphere.jsurf": "surface_equation=x^2+y^2+z^2-a\nsurface_parameter_a=0.8\nscale_factor=0.5\n"
                    "rotation_matrix_0=1 0 0\nlight_position_0=1 2 3\n",
    "cubic.pic": "double a = 0.5;\nsurface = x^3+y^3+z^3-a;\nrot_x = 0.3; scale_x = 0.9;\n"
                 "draw_surface;\n",
    "balls.pov": "#declare f = function { x*x + y*y + z*z - 1 }\ncamera { location <0,0,-5> "
                 "look_at 0 }\n#macro P(a) <a,a,a> #end\nisosurface { function { f(x,y,z) + "
                 "0.1*sin(9*x) } contained_by { box { -2, 2 } } pigment { rgb P(0.5) } "
                 "rotate <0,30,0> }\nsphere { 0, 1 translate y*2 }\n",
    "mathmodcollection.js": json.dumps({"MathModels": [
        {"Iso3D": {"Name": ["Torus"], "Fxyz": ["(sqrt(x*x+y*y)-3)^2+z*z-1"], "Xmax": ["5"],
                   "Xmin": ["-5"], "Ymax": ["5"], "Ymin": ["-5"], "Zmax": ["5"], "Zmin": ["-5"]}},
        {"Param3D": {"Name": ["Tube"], "Component": ["T"], "Fx": ["cos(u)"], "Fy": ["sin(u)"],
                     "Fz": ["v"], "Umin": ["0"], "Umax": ["2*pi"], "Vmin": ["0"],
                     "Vmax": ["1"]}}]}),
}


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in TEXTS.items():
        (folder / name).write_text(text, encoding="utf-8")
    for name, data in {"a.mha": meta_image(), "a.nii": nifti(), "b.nii.gz": gzip.compress(nifti()),
                       "a.vti": vtk_image(), "a.dcm": dicom(), "a.mgz": gzip.compress(mgh()),
                       "a.mgh": mgh(), "a.mrc": mrc(), "a.vtk": vtk_legacy(),
                       "a.tif": tiff_stack()}.items():
        (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
