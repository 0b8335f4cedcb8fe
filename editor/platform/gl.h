// The OpenGL functions the editor calls, loaded once a context is current. What is listed is common to OpenGL 3.3 core and
// OpenGL ES 3.0 (WebGL 2), so that a browser can run the same renderer.
#pragma once
#include <GL/glcorearb.h>

namespace pinfield::editor {

#define PINFIELD_GL_FUNCTIONS(X)                       \
    X(ActiveTexture, ACTIVETEXTURE)                    \
    X(AttachShader, ATTACHSHADER)                      \
    X(BindAttribLocation, BINDATTRIBLOCATION)          \
    X(BindBuffer, BINDBUFFER)                          \
    X(BindFramebuffer, BINDFRAMEBUFFER)                \
    X(BindTexture, BINDTEXTURE)                        \
    X(BindVertexArray, BINDVERTEXARRAY)                \
    X(BlendFunc, BLENDFUNC)                            \
    X(BlitFramebuffer, BLITFRAMEBUFFER)                \
    X(BufferData, BUFFERDATA)                          \
    X(Clear, CLEAR)                                    \
    X(ClearColor, CLEARCOLOR)                          \
    X(CompileShader, COMPILESHADER)                    \
    X(CreateProgram, CREATEPROGRAM)                    \
    X(CreateShader, CREATESHADER)                      \
    X(DeleteBuffers, DELETEBUFFERS)                    \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS)          \
    X(DeleteProgram, DELETEPROGRAM)                    \
    X(DeleteShader, DELETESHADER)                      \
    X(DeleteTextures, DELETETEXTURES)                  \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS)          \
    X(Disable, DISABLE)                                \
    X(DrawArrays, DRAWARRAYS)                          \
    X(Enable, ENABLE)                                  \
    X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) \
    X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D)      \
    X(GenBuffers, GENBUFFERS)                          \
    X(GenFramebuffers, GENFRAMEBUFFERS)                \
    X(GenTextures, GENTEXTURES)                        \
    X(GenerateMipmap, GENERATEMIPMAP)                  \
    X(GenVertexArrays, GENVERTEXARRAYS)                \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG)            \
    X(GetProgramiv, GETPROGRAMIV)                      \
    X(GetShaderInfoLog, GETSHADERINFOLOG)              \
    X(GetShaderiv, GETSHADERIV)                        \
    X(GetUniformLocation, GETUNIFORMLOCATION)          \
    X(LinkProgram, LINKPROGRAM)                        \
    X(PixelStorei, PIXELSTOREI)                        \
    X(ReadPixels, READPIXELS)                          \
    X(Scissor, SCISSOR)                                \
    X(ShaderSource, SHADERSOURCE)                      \
    X(TexImage2D, TEXIMAGE2D)                          \
    X(TexParameteri, TEXPARAMETERI)                    \
    X(TexSubImage2D, TEXSUBIMAGE2D)                    \
    X(Uniform1f, UNIFORM1F)                            \
    X(Uniform1i, UNIFORM1I)                            \
    X(Uniform2f, UNIFORM2F)                            \
    X(Uniform3fv, UNIFORM3FV)                          \
    X(Uniform4f, UNIFORM4F)                            \
    X(UseProgram, USEPROGRAM)                          \
    X(VertexAttribPointer, VERTEXATTRIBPOINTER)        \
    X(Viewport, VIEWPORT)

/// The functions of one context; handed to everything that draws.
struct Gl {
#define PINFIELD_GL_MEMBER(name, upper) PFNGL##upper##PROC name = nullptr;
    PINFIELD_GL_FUNCTIONS(PINFIELD_GL_MEMBER)
#undef PINFIELD_GL_MEMBER
    /// First lines of every shader: "#version 330 core" or "#version 300 es" with precisions.
    const char* shader_head = "#version 330 core\n";
};

}  // namespace pinfield::editor
