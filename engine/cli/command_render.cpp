// pinfield render FILE -o OUT.png: a picture of the table at rest.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/cli/part_marks.h"
#include "engine/cli/table.h"
#include "engine/core/numbers.h"
#include "engine/io/png.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/isolines.h"
#include "engine/program/raster.h"

namespace pinfield::cli {
namespace {

constexpr int most_pixels_a_side = 16384;

struct Options {
    std::string file, out, size, mode = "shaded";
    bool parts = false;
};

struct Size {
    int width = 0, height = 0;
};

/// "520x1060" as two numbers of pixels; anything else is wrong usage.
std::string why_invalid_size(const std::string& text, Size* size = nullptr) {
    const std::size_t x = text.find('x');
    const auto width = x == std::string::npos ? std::nullopt : parse_number(text.substr(0, x));
    const auto height = x == std::string::npos ? std::nullopt : parse_number(text.substr(x + 1));
    const auto fits = [](const std::optional<double>& n) { return n && *n >= 1 && *n <= most_pixels_a_side && *n == static_cast<int>(*n); };
    if (!fits(width) || !fits(height))
        return fmt::format("\"{}\" is no size: WIDTHxHEIGHT in pixels, at most {} each", text, most_pixels_a_side);
    if (size) *size = {static_cast<int>(*width), static_cast<int>(*height)};
    return "";
}

/// The whole table, centred, in the picture's proportions.
Box2 window_of(const Program& program, const Size& size) {
    const double metres_per_pixel = std::max(program.size.x() / size.width, program.size.y() / size.height);
    const Vec2 half = 0.5 * metres_per_pixel * Vec2(size.width, size.height);
    const Vec2 centre = 0.5 * program.size;
    return {centre - half, centre + half};
}

/// A pixel a millimetre, unless that is too many.
Size usual_size(const Program& program) {
    const double longer = std::max(program.size.x(), program.size.y());
    const double scale = std::min(1000.0, 2000 / longer);
    const auto pixels = [&](double metres) { return std::max(1, static_cast<int>(std::lround(metres * scale))); };
    return {pixels(program.size.x()), pixels(program.size.y())};
}

void render(const Options& options) {
    refuse_overwriting(options.out, {options.file});
    const Table table = open_table(options.file, {options.out});
    const Program& program = *table.program;
    Size size = usual_size(program);
    if (!options.size.empty()) why_invalid_size(options.size, &size);

    Raster raster;
    raster.width = size.width;
    raster.height = size.height;
    raster.window = window_of(program, size);
    const sdf::Isa isa = sdf::best_isa();
    rasterize(program.fixed, ground_layer, isa, raster);
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        rasterize_over(program.movers[i], world_from_resting_mover(program, static_cast<int>(i)), isa, raster);
    std::vector<unsigned char> rgb = options.mode == "isolines"
                                               ? isoline_picture(raster, isolines::spacing(raster.metres_per_pixel()))
                                               : shaded_picture(raster, program);
    if (options.parts) mark_parts(program, raster, isa, rgb);
    const std::string bytes = value_or_stop(encode_png(options.out, size.width, size.height, rgb));
    Output out(options.out);
    out.write(bytes);
    out.finish();
}

}  // namespace

void add_render(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("render", "Draw a table into a PNG");
    const auto options = std::make_shared<Options>();
    command.option("FILE", options->file, "Table file").required().offer(Offer::Kind::tables);
    command.option("-o,--output", options->out, "Picture to write; - for stdout").required().check(why_no_output).offer(Offer::Kind::files);
    command.option("--size", options->size, "Pixels as WIDTHxHEIGHT; a pixel a millimetre when not given")
        .check([](const std::string& text) { return why_invalid_size(text); });
    command.option("--mode", options->mode, "shaded or isolines").one_of({"shaded", "isolines"}).show_default();
    command.flag("--parts", options->parts, "Mark where balls start and drain, and how far flippers and plungers go");
    command.callback([options, &exit] {
        render(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
