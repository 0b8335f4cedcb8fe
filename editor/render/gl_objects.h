// OpenGL objects that free themselves: shader programs, field textures, quads.
#pragma once
#include <string>
#include <vector>

#include "editor/platform/gl.h"
#include "engine/core/geometry.h"

namespace pinfield::editor {

struct Rgb {
    float r = 0, g = 0, b = 0;
    bool operator==(const Rgb&) const = default;
};

/// Vertex and fragment shader of our own; a shader that does not compile is a programming error and ends the program with its log.
class ShaderProgram {
public:
    ShaderProgram(const Gl& gl, const std::string& vertex, const std::string& fragment);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void use() const { gl_.UseProgram(program_); }
    void set(const char* name, int value) const { gl_.Uniform1i(place(name), value); }
    void set(const char* name, double value) const { gl_.Uniform1f(place(name), static_cast<float>(value)); }
    void set(const char* name, const Vec2& value) const;
    void set(const char* name, const Rgb& color, double alpha) const;
    void set(const char* name, const std::vector<Rgb>& colors) const;

private:
    int place(const char* name) const { return gl_.GetUniformLocation(program_, name); }

    const Gl& gl_;
    unsigned program_ = 0;
};

/// Distances (and which material is nearest) over a grid.
class FieldTexture {
public:
    explicit FieldTexture(const Gl& gl);
    ~FieldTexture();
    FieldTexture(const FieldTexture&) = delete;
    FieldTexture& operator=(const FieldTexture&) = delete;

    /// Row 0 is the top of the picture; `material` may be null.
    void upload(int width, int height, const float* distance, const short* material);
    /// The same picture, of which some rows have changed: `distance` and `material` are whole still.
    void upload_rows(int first, int count, const float* distance, const short* material) const;
    void bind() const;  ///< distances to unit 0, materials to unit 1
    int width() const { return width_; }
    int height() const { return height_; }

private:
    const Gl& gl_;
    unsigned distance_ = 0, material_ = 0;
    int width_ = 0, height_ = 0;
};

/// A photograph, shown at any size.
class PictureTexture {
public:
    explicit PictureTexture(const Gl& gl);
    ~PictureTexture();
    PictureTexture(const PictureTexture&) = delete;
    PictureTexture& operator=(const PictureTexture&) = delete;

    /// Rows from the top, four bytes a pixel.
    void upload(int width, int height, const unsigned char* rgba);
    /// To a unit; one pixel without color before the first upload.
    void bind(int unit) const;

private:
    const Gl& gl_;
    unsigned texture_ = 0;
};

/// A picture that is drawn once and shown many times.
class KeptPicture {
public:
    explicit KeptPicture(const Gl& gl);
    ~KeptPicture();
    KeptPicture(const KeptPicture&) = delete;
    KeptPicture& operator=(const KeptPicture&) = delete;

    void begin(int width, int height);  ///< what is drawn from now on goes into it
    void end() const;                   ///< and then to the window again; the viewport is whoever's draws next
    /// Copied pixel by pixel onto the window, `left` and `bottom` device pixels from its bottom left corner.
    void show(int left, int bottom) const;

private:
    const Gl& gl_;
    unsigned buffer_ = 0, texture_ = 0;
    int width_ = 0, height_ = 0;
};

/// Triangles of vertices (place in pixels of the canvas, place in the picture, one more number).
class QuadBuffer {
public:
    explicit QuadBuffer(const Gl& gl);
    ~QuadBuffer();
    QuadBuffer(const QuadBuffer&) = delete;
    QuadBuffer& operator=(const QuadBuffer&) = delete;

    void clear() { vertices_.clear(); }
    /// Corners in the order bottom left, bottom right, top right, top left of the picture.
    void add(const Vec2 (&corners)[4], const Vec2& picture_lo, const Vec2& picture_hi, double extra = 0);
    void draw();

private:
    const Gl& gl_;
    unsigned array_ = 0, buffer_ = 0;
    std::vector<float> vertices_;
};

/// Where in the window a table is drawn, in device pixels (y down), and which part of the world it shows.
struct Canvas {
    Vec2 framebuffer{1, 1};
    Vec2 origin{0, 0}, size{1, 1};
    Vec2 centre{0, 0};  ///< world
    double pixels_per_metre = 1;

    int left() const { return static_cast<int>(origin.x()); }
    int bottom() const { return static_cast<int>(framebuffer.y() - origin.y() - size.y()); }  ///< from the window's lower edge up
    int width() const { return static_cast<int>(size.x()); }
    int height() const { return static_cast<int>(size.y()); }
    Vec2 pixel_from_world(const Vec2& p) const {
        return {0.5 * size.x() + (p.x() - centre.x()) * pixels_per_metre,
                0.5 * size.y() - (p.y() - centre.y()) * pixels_per_metre};
    }
    Box2 world() const {
        const Vec2 half = 0.5 * size / pixels_per_metre;
        return {centre - half, centre + half};
    }
};

}  // namespace pinfield::editor
