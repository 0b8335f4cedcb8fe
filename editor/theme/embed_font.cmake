# cmake -D FILES=a.otf,b.otf -D NAMES=one,two -D OUT=fonts.cpp -P embed_font.cmake
# Writes the files as arrays of bytes, so that the program needs no file beside it.
string(REPLACE "," ";" FILES "${FILES}")
string(REPLACE "," ";" NAMES "${NAMES}")
set(text "#include \"editor/theme/embedded_fonts.h\"\n\nnamespace pinfield::editor {\n")
foreach(file name IN ZIP_LISTS FILES NAMES)
    file(READ ${file} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(APPEND text "static const unsigned char ${name}_bytes[] = {${bytes}};\n"
                       "const EmbeddedFont ${name}{${name}_bytes, sizeof ${name}_bytes};\n")
endforeach()
string(APPEND text "}  // namespace pinfield::editor\n")
file(WRITE ${OUT} "${text}")
