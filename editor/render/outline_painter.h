// Outlines of scene nodes: what is selected, what is under the mouse, where drains are.
#pragma once
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "editor/render/gl_objects.h"
#include "editor/render/table_painter.h"
#include "engine/program/program.h"

namespace pinfield::editor {

struct OutlineStyle {
    Rgb color;
    double alpha = 1;
    double width = 2;  ///< pixels
    double fill = 0;   ///< opacity of the inside
    double hatch = 0;  ///< opacity of stripes inside
};

class OutlinePainter {
public:
    explicit OutlinePainter(const Gl& gl);

    /// Draws the outline of the solid of a scene node (of everything compiled from it), wherever it is in the program.
    /// Returns whether anything was found to draw.
    bool draw(const ProgramPtr& program, std::span<const MoverPlace> places, NodeId node, const OutlineStyle& style,
              const Canvas& canvas);

private:
    struct Picture {
        std::unique_ptr<FieldTexture> texture;
        Box2 window;     ///< in its field's frame
        int mover = -1;  ///< whose frame that is; -1: the world's
    };
    const std::vector<Picture>& pictures_of(const ProgramPtr& program, NodeId node, const Canvas& canvas);
    void add_picture(std::vector<Picture>& out, const Field& field, NodeId node, int mover, const Canvas& canvas);

    const Gl& gl_;
    ShaderProgram shader_;
    QuadBuffer quads_;
    ProgramPtr program_;
    Canvas canvas_;
    std::map<NodeId, std::vector<Picture>> pictures_;  ///< for this program and canvas
};

}  // namespace pinfield::editor
