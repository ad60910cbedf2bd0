# Writes OUTPUT, a C++ source with a function FUNCTION, declared by HEADER, that returns the bytes of
# each of FILES as a string literal.
set(source "#include \"${HEADER}\"\n\nnamespace zeroset {\n\n")
string(APPEND source "std::span<const std::string_view> ${FUNCTION}() {\n")
string(APPEND source "    static constexpr std::string_view files[] = {\n")
foreach(file IN LISTS FILES)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" escaped "${hex}")
  string(REGEX REPLACE "(................................................................)"
                       "\\1\"\n        \"" escaped "${escaped}")
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(APPEND source "        {\"${escaped}\", ${size}},\n")
endforeach()
string(APPEND source "    };\n    return files;\n}\n\n}  // namespace zeroset\n")
file(WRITE ${OUTPUT} "${source}")
