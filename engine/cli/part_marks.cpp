#include "engine/cli/part_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/at.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/pose.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield::cli {
namespace {

struct Ink {
    double red, green, blue;
};
constexpr Ink drain_ink{230, 90, 90}, spawn_ink{120, 230, 140}, swing_ink{250, 210, 110};
constexpr double way_shown = 0.1;  // seconds
constexpr double half_line = 0.8;  // pixels

/// Mixes an ink into a pixel; `share` of it may be anything, and is cut to 0..1.
void mix(std::vector<unsigned char>& rgb, std::size_t pixel, const Ink& ink, double share) {
    share = std::clamp(share, 0.0, 1.0);
    const double values[] = {ink.red, ink.green, ink.blue};
    for (std::size_t c = 0; c < 3; ++c) {
        unsigned char& byte = rgb[3 * pixel + c];
        byte = static_cast<unsigned char>(std::lround((1 - share) * byte + share * at(values, c)));
    }
}

Raster empty_like(const Raster& picture) {
    Raster raster;
    raster.width = picture.width;
    raster.height = picture.height;
    raster.window = picture.window;
    return raster;
}

/// How much of a line along the zero of a distance covers a pixel.
double on_line(double distance, double pixel) { return half_line + 0.5 - std::fabs(distance) / pixel; }

void mark_drains(const Program& program, const Raster& picture, sdf::Isa isa, std::vector<unsigned char>& rgb) {
    const double pixel = picture.metres_per_pixel();
    for (const Sensor& sensor : program.sensors) {
        Raster raster = empty_like(picture);
        rasterize(sensor.field, ~LayerMask{0}, isa, raster);
        for (std::size_t k = 0; k < raster.distance.size(); ++k) {
            const double distance = static_cast<double>(raster.distance[k]);
            mix(rgb, k, drain_ink, std::max(distance < 0 ? 0.35 : 0.0, on_line(distance, pixel)));
        }
    }
}

void mark_swings(const Program& program, const Raster& picture, sdf::Isa isa, std::vector<unsigned char>& rgb) {
    const double pixel = picture.metres_per_pixel();
    for (int m = 0; m < static_cast<int>(program.movers.size()); ++m) {
        const MoverState rest = mover_at_rest(program, m);
        for (const double q : {rest.q_min, rest.q_max}) {
            Raster raster = empty_like(picture);
            raster.distance.assign(picture.distance.size(), std::numeric_limits<float>::infinity());
            raster.material.assign(picture.material.size(), -1);
            rasterize_over(at(program.movers, m), world_from_mover(at(program.movers, m), q), isa, raster);
            for (std::size_t k = 0; k < raster.distance.size(); ++k) mix(rgb, k, swing_ink, on_line(static_cast<double>(raster.distance[k]), pixel));
        }
    }
}

void mark_spawns(const Program& program, const Raster& picture, std::vector<unsigned char>& rgb) {
    const double pixel = picture.metres_per_pixel(), r = program.physics.ball_radius;
    for (const Part& part : program.parts) {
        if (!part.is<parts::Spawn>()) continue;
        const Point<double> velocity = part.as<parts::Spawn>().velocity;
        const Vec2 centre = part.world_from_part.offset, way = way_shown * part.world_from_part.direction({velocity.x, velocity.y});
        const double squared = dot(way, way);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const Vec2 p = picture.window.lo + pixel * Vec2(x + 0.5, picture.height - y - 0.5), from = p - centre;
                const double u = squared > 0 ? std::clamp(dot(from, way) / squared, 0.0, 1.0) : 0.0;
                const double to_way = squared > 0 ? length(from - u * way) : infinity;
                const double share = std::max(on_line(length(from) - r, pixel), on_line(to_way, pixel));
                if (share > 0) mix(rgb, static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x), spawn_ink, share);
            }
    }
}

}  // namespace

void mark_parts(const Program& program, const Raster& picture, sdf::Isa isa, std::vector<unsigned char>& rgb) {
    mark_drains(program, picture, isa, rgb);
    mark_swings(program, picture, isa, rgb);
    mark_spawns(program, picture, rgb);
}

}  // namespace pinfield::cli
