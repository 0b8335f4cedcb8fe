// pinfield eval FILE --points P.csv: the table's signed distance, its gradient, the surface it belongs to, and whether it is the true
// distance or a bound of it, point by point.
#include <fmt/format.h>

#include <cmath>

#include "engine/cli/command.h"
#include "engine/cli/csv.h"
#include "engine/cli/output.h"
#include "engine/cli/table.h"
#include "engine/core/at.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/program/evaluate.h"
#include "engine/scene/parts/domain.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string file, points, out;
    bool shapes_only = false;
};

/// Of a point's coordinates: formulas square and cube them, and what overflows has no distance.
constexpr double farthest = 1e50;

/// A static solid that bounds the space for balls instead of standing in it: the domain, written or made of the table's size.
bool is_domain(const Table& table, const Solid& solid) {
    return solid.part < 0 ? solid.origin == table.scene.table().id
                          : at(table.program->parts, solid.part).is<parts::Domain>();
}

/// Something to ask for its distance: a whole field, or one solid of it, and where it stands.
struct Source {
    const Field* field = nullptr;
    int solid = -1;  ///< -1: all
    Similarity world_from_field;

    /// The gradient in the world.
    Nearest ask(const Vec2& world) const {
        const Vec2 p = world_from_field.inverse() * world;
        Nearest found = solid < 0 ? nearest(*field, p) : nearest_of_solid(*field, solid, p);
        found.gradient = world_from_field.direction(found.gradient);
        return found;
    }
};

std::vector<Source> sources_of(const Table& table, bool shapes_only) {
    const Program& program = *table.program;
    std::vector<Source> sources;
    if (!shapes_only) sources.push_back({&program.fixed, -1, {}});
    for (std::size_t i = 0; shapes_only && i < program.fixed.solids.size(); ++i)
        if ((program.fixed.solids[i].layers & ground_layer) && !is_domain(table, program.fixed.solids[i]))
            sources.push_back({&program.fixed, static_cast<int>(i), {}});
    for (std::size_t i = 0; i < program.movers.size(); ++i)
        sources.push_back({&program.movers[i].field, -1, world_from_resting_mover(program, static_cast<int>(i))});
    return sources;
}

struct Answer {
    Nearest nearest;
    NodeId node;
};

/// The least of all sources' answers. It is the true distance if it is its own source's and, for a point within, the way out ends in the
/// open; outside all of them what the others say is a bound, and none can truly be nearer.
Answer answer_at(const std::vector<Source>& sources, const Vec2& p) {
    Answer answer;
    const Source* winner = nullptr;
    for (const Source& source : sources) {
        const Nearest found = source.ask(p);
        if (found.leaf < 0 || found.distance >= answer.nearest.distance) continue;
        answer = {found, at(source.field->ops, found.leaf).origin};
        winner = &source;
    }
    const Exit way = exit_of(answer.nearest, p);
    if (answer.nearest.certified && way.is_needed)
        for (const Source& other : sources)
            if (&other != winner && other.ask(way.beyond).distance <= way.clearance) answer.nearest.certified = false;
    return answer;
}

void eval(const Options& options) {
    refuse_overwriting(options.out, {options.file, options.points});
    const Table table = open_table(options.file, {options.out});
    const std::vector<Source> sources = sources_of(table, options.shapes_only);
    CsvReader points = value_or_stop(CsvReader::open(options.points, "x,y"));

    Output out(options.out);
    out.write("x,y,distance,grad_x,grad_y,node,certified\n");
    CsvRecord record;
    while (value_or_stop(points.next(record))) {
        const Vec2 p(value_or_stop(csv_number(options.points, record, 0)), value_or_stop(csv_number(options.points, record, 1)));
        if (!(std::fabs(p.x()) <= farthest && std::fabs(p.y()) <= farthest))
            throw Stop{ExitCode::failed, fmt::format("{}:{}: the point is farther out than {:g} m", options.points, record.line, farthest), ""};
        const auto& [found, node] = answer_at(sources, p);
        out.write(fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{:d}\n", p.x(), p.y(), found.distance, found.gradient.x(),
                              found.gradient.y(), found.leaf < 0 ? "" : name_of(table.scene, node), found.certified));
    }
    out.finish();
}

}  // namespace

void add_eval(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand(
        "eval", "Evaluate the signed distance of a table's solids at points, and tell where it is certified to be the true one");
    const auto options = std::make_shared<Options>();
    command.option("FILE", options->file, "Table file").required().offer(Offer::Kind::tables);
    command.option("--points", options->points, "CSV with the header x,y, metres").required().offer(Offer::Kind::files);
    command.option("-o,--output", options->out, "CSV to write; stdout when not given").check(why_no_output).offer(Offer::Kind::files);
    command.flag("--shapes-only", options->shapes_only, "Leave the domain out");
    command.callback([options, &exit] {
        eval(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
