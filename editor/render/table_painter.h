// Draws a running table: the Program's own raster colored by a shader, the movers at their places, the balls.
#pragma once
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "editor/render/gl_objects.h"
#include "engine/program/raster.h"

namespace pinfield::editor {

/// What of a ball is drawn.
struct BallMark {
    Vec2 centre{0, 0};  ///< world
    double radius = 0;  ///< metres
    double ghost = 0;   ///< 0 there, 1 gone: balls out of play
};

/// Where a mover is.
struct MoverPlace {
    double q = 0;  ///< its degree of freedom
    Similarity world_from_mover;
};

/// The picture beneath the table.
struct UnderlayLook {
    Vec2 corner{0, 0}, size{1, 1};  ///< world: the lower left one, metres
    int quarter_turns = 0;          ///< to the left
    double opacity = 0;             ///< 0: there is none
    bool over = false;              ///< it lies over the table, too
    bool operator==(const UnderlayLook&) const = default;
};

struct TableLook {
    bool isolines = false;
    std::vector<Rgb> materials;        ///< parallel to Program::materials
    Rgb floor_low, floor_high, backdrop;
    Rgb rim{0.110f, 0.118f, 0.138f};  ///< the frame around the table
    double shadow = 1;                ///< how strong shadows are
    UnderlayLook underlay{};          ///< of the picture set last
    bool operator==(const TableLook&) const = default;
};

class TablePainter {
public:
    explicit TablePainter(const Gl& gl);

    /// The picture beneath the table from now on: rows from the top, four bytes a pixel.
    void set_underlay(int width, int height, const unsigned char* rgba);
    /// `places`: parallel to Program::movers. Rasters and shades again only what changed since the last call. Sets the viewport.
    void draw(const ProgramPtr& program, std::span<const MoverPlace> places, std::span<const BallMark> balls,
              const TableLook& look, const Canvas& canvas);

private:
    struct MoverPicture {
        std::unique_ptr<FieldTexture> texture;
        Box2 window;  ///< in the mover's frame
    };

    /// The pixels that changed.
    PixelBox refresh_table(const ProgramPtr& program, std::span<const MoverPlace> places, bool isolines, const Canvas& canvas);
    void refresh_movers(const ProgramPtr& program, double pixels_per_metre);
    /// Into the kept picture, as far as it looks different from what that shows.
    void keep_table(const Program& program, PixelBox changed, const TableLook& look, const Canvas& canvas);
    void draw_table(const Program& program, const TableLook& look, const Canvas& canvas);
    void set_underlay_look(const UnderlayLook& underlay) const;
    void draw_movers(const Program& program, std::span<const MoverPlace> places, const TableLook& look, const Canvas& canvas);
    void draw_balls(std::span<const BallMark> balls, const Canvas& canvas);
    void prepare(const TableLook& look, const Canvas& canvas, const FieldTexture& texture, double metres_per_texel,
                 const Vec2& light) const;

    const Gl& gl_;
    ShaderProgram field_shader_, ball_shader_;
    QuadBuffer quads_;
    FieldTexture table_;
    PictureTexture underlay_;
    bool underlay_is_new_ = false;
    KeptPicture kept_;  ///< the table without movers and balls
    TableLook kept_look_;
    Raster raster_;
    std::vector<MoverPicture> movers_;
    // What the textures hold, to know when to raster again.
    ProgramPtr table_program_, movers_program_;
    Canvas table_canvas_;
    std::vector<double> table_places_;  ///< of the movers laid over the table; empty when drawn apart
    double movers_scale_ = 0;
};

}  // namespace pinfield::editor
