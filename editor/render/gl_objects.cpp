#include "editor/render/gl_objects.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace pinfield::editor {

namespace {

[[noreturn]] void shader_is_wrong(const char* what, const std::array<char, 2048>& log) {
    static_cast<void>(std::fprintf(stderr, "pinfield-editor: %s: %s\n", what, log.data()));
    std::abort();
}

unsigned compile_shader(const Gl& gl, GLenum kind, const std::string& source) {
    const unsigned shader = gl.CreateShader(kind);
    const char* const parts[2] = {gl.shader_head, source.c_str()};
    gl.ShaderSource(shader, 2, parts, nullptr);
    gl.CompileShader(shader);
    int fine = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &fine);
    if (!fine) {
        std::array<char, 2048> log{};
        gl.GetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
        shader_is_wrong("a shader does not compile", log);
    }
    return shader;
}

constexpr int floats_per_vertex = 5;

}  // namespace

ShaderProgram::ShaderProgram(const Gl& gl, const std::string& vertex, const std::string& fragment)
    : gl_(gl), program_(gl.CreateProgram()) {
    const unsigned v = compile_shader(gl, GL_VERTEX_SHADER, vertex);
    const unsigned f = compile_shader(gl, GL_FRAGMENT_SHADER, fragment);
    gl.AttachShader(program_, v);
    gl.AttachShader(program_, f);
    gl.BindAttribLocation(program_, 0, "place");
    gl.BindAttribLocation(program_, 1, "picture");
    gl.BindAttribLocation(program_, 2, "extra");
    gl.LinkProgram(program_);
    gl.DeleteShader(v);
    gl.DeleteShader(f);
    int fine = 0;
    gl.GetProgramiv(program_, GL_LINK_STATUS, &fine);
    if (!fine) {
        std::array<char, 2048> log{};
        gl.GetProgramInfoLog(program_, static_cast<int>(log.size()), nullptr, log.data());
        shader_is_wrong("shaders do not link", log);
    }
}

ShaderProgram::~ShaderProgram() { gl_.DeleteProgram(program_); }

void ShaderProgram::set(const char* name, const Vec2& value) const {
    gl_.Uniform2f(place(name), static_cast<float>(value.x()), static_cast<float>(value.y()));
}

void ShaderProgram::set(const char* name, const Rgb& color, double alpha) const {
    gl_.Uniform4f(place(name), color.r, color.g, color.b, static_cast<float>(alpha));
}

void ShaderProgram::set(const char* name, const std::vector<Rgb>& colors) const {
    static_assert(sizeof(Rgb) == 3 * sizeof(float), "colors are handed over as packed floats");
    gl_.Uniform3fv(place(name), static_cast<int>(colors.size()), &colors.data()->r);
}

FieldTexture::FieldTexture(const Gl& gl) : gl_(gl) {
    gl.GenTextures(1, &distance_);
    gl.GenTextures(1, &material_);
}

FieldTexture::~FieldTexture() {
    gl_.DeleteTextures(1, &distance_);
    gl_.DeleteTextures(1, &material_);
}

void FieldTexture::upload(int width, int height, const float* distance, const short* material) {
    width_ = width;
    height_ = height;
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto set_up = [&](unsigned texture, int filter) {
        gl_.BindTexture(GL_TEXTURE_2D, texture);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    };
    gl_.ActiveTexture(GL_TEXTURE0);
    set_up(distance_, GL_LINEAR);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, distance);
    set_up(material_, GL_NEAREST);
    if (material)
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R16I, width, height, 0, GL_RED_INTEGER, GL_SHORT, material);
}

void FieldTexture::upload_rows(int first, int count, const float* distance, const short* material) const {
    const std::size_t from = static_cast<std::size_t>(first) * static_cast<std::size_t>(width_);
    bind();
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, first, width_, count, GL_RED, GL_FLOAT, distance + from);
    gl_.BindTexture(GL_TEXTURE_2D, material_);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, first, width_, count, GL_RED_INTEGER, GL_SHORT, material + from);
}

void FieldTexture::bind() const {
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, material_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, distance_);
}

PictureTexture::PictureTexture(const Gl& gl) : gl_(gl) {
    gl.GenTextures(1, &texture_);
    constexpr unsigned char nothing[4] = {};
    upload(1, 1, nothing);
}

PictureTexture::~PictureTexture() { gl_.DeleteTextures(1, &texture_); }

void PictureTexture::upload(int width, int height, const unsigned char* rgba) {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl_.GenerateMipmap(GL_TEXTURE_2D);
}

void PictureTexture::bind(int unit) const {
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.ActiveTexture(GL_TEXTURE0);
}

KeptPicture::KeptPicture(const Gl& gl) : gl_(gl) {
    gl.GenFramebuffers(1, &buffer_);
    gl.GenTextures(1, &texture_);
}

KeptPicture::~KeptPicture() {
    gl_.DeleteFramebuffers(1, &buffer_);
    gl_.DeleteTextures(1, &texture_);
}

void KeptPicture::begin(int width, int height) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, buffer_);
    if (width != width_ || height != height_) {
        width_ = width;
        height_ = height;
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.BindTexture(GL_TEXTURE_2D, texture_);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    }
    gl_.Viewport(0, 0, width, height);
}

void KeptPicture::end() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, 0); }

void KeptPicture::show(int left, int bottom) const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, buffer_);
    gl_.BlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

QuadBuffer::QuadBuffer(const Gl& gl) : gl_(gl) {
    gl.GenVertexArrays(1, &array_);
    gl.GenBuffers(1, &buffer_);
    gl.BindVertexArray(array_);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    constexpr int stride = floats_per_vertex * static_cast<int>(sizeof(float));
    const auto attribute = [&](unsigned index, int count, std::size_t first) {
        gl.EnableVertexAttribArray(index);
        // OpenGL takes an offset for a pointer here. NOLINTNEXTLINE(performance-no-int-to-ptr)
        gl.VertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(first * sizeof(float)));
    };
    attribute(0, 2, 0);
    attribute(1, 2, 2);
    attribute(2, 1, 4);
    gl.BindVertexArray(0);
}

QuadBuffer::~QuadBuffer() {
    gl_.DeleteBuffers(1, &buffer_);
    gl_.DeleteVertexArrays(1, &array_);
}

void QuadBuffer::add(const Vec2 (&corners)[4], const Vec2& picture_lo, const Vec2& picture_hi, double extra) {
    const Vec2 picture[4] = {picture_lo, {picture_hi.x(), picture_lo.y()}, picture_hi, {picture_lo.x(), picture_hi.y()}};
    for (const int i : {0, 1, 2, 0, 2, 3})
        for (const double x : {corners[i].x(), corners[i].y(), picture[i].x(), picture[i].y(), extra})
            vertices_.push_back(static_cast<float>(x));
}

void QuadBuffer::draw() {
    if (vertices_.empty()) return;
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(float)), vertices_.data(), GL_STREAM_DRAW);
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<int>(vertices_.size()) / floats_per_vertex);
    gl_.BindVertexArray(0);
}

}  // namespace pinfield::editor
