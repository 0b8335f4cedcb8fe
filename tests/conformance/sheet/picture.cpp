#include "tests/conformance/sheet/picture.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "engine/io/png.h"
#include "engine/program/compile.h"
#include "engine/program/raster.h"

namespace pinfield::conformance {
namespace {

constexpr int pixels = 340;     // each way
constexpr int samples = 2;      // each way, to a pixel: lines without steps
constexpr int levels = 4;       // a shade is a multiple of this: unseen, and half the file

/// The mean of each square of samples.
std::vector<unsigned char> shrunk(const std::vector<unsigned char>& fine) {
    std::vector<unsigned char> out;
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int j = 0; j < samples; ++j)
                    for (int i = 0; i < samples; ++i)
                        sum += at(fine, 3 * ((y * samples + j) * pixels * samples + x * samples + i) + channel);
                const int mean = (sum + samples * samples * levels / 2) / (samples * samples * levels) * levels;
                out.push_back(static_cast<unsigned char>(std::min(mean, 255)));
            }
    return out;
}

}  // namespace

Result<bool> draw_example(const std::string& scene_path, const std::shared_ptr<const Catalog>& catalog, const std::string& png_path) {
    const Result<Reading> table = load_table(scene_path, catalog);
    if (!table) return tl::unexpected(table.error());
    if (!table->ok()) return failure(scene_path + " has errors: see `pinfield check`");
    const auto program = compile(table->scene);
    if (!program) return failure(scene_path + " does not compile: see `pinfield check`");
    const Vec2 size = (*program)->size;
    if (size.x() != size.y()) return failure(scene_path + ": the table of an example is square");
    Raster raster{pixels * samples, pixels * samples, Box2::of({0, 0}, size), {}, {}};
    // The baseline instruction set: the same picture from every machine.
    rasterize((*program)->fixed, ground_layer, sdf::Isa::sse2, raster);
    return write_png(png_path, pixels, pixels, shrunk(isoline_picture(raster, 0.010)));
}

}  // namespace pinfield::conformance
