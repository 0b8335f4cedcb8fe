// pinfield eval FILE --points P.csv: the table's signed distance, its gradient, the surface it belongs to, and whether
// it is certified to be the distance, point by point.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "engine/cli/command.h"
#include "engine/cli/csv.h"
#include "engine/cli/output.h"
#include "engine/cli/rest_pose.h"
#include "engine/cli/table.h"
#include "engine/program/evaluate.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string file, points, out;
    bool shapes_only = false;
};

/// The nearest surface so far.
struct Answer {
    double distance = infinity;
    Vec2 gradient{0, 0};
    NodeId node;
    bool certified = false;
    double next = infinity;  ///< least of the others' distances

    void offer(const Nearest& nearest, const Field& field, const Vec2& turned_gradient) {
        if (nearest.leaf < 0) return;
        next = std::min(next, std::max(nearest.distance, distance));
        if (nearest.distance >= distance) return;
        distance = nearest.distance;
        gradient = turned_gradient;
        certified = nearest.certified;
        node = field.ops[static_cast<std::size_t>(nearest.leaf)].origin;
    }
    /// From outside nothing else can be nearer: what is not certified is a bound of its own distance. From inside, the end of the way out
    /// must lie in nothing else.
    bool is_certified() const { return certified && (distance >= 0 || next > -distance); }
};

/// A static solid that bounds the space for balls instead of standing in it: the domain, written or made of the table's size.
bool is_boundary(const Table& table, const Solid& solid) {
    return solid.part < 0 ? solid.origin == table.scene.table().id
                          : table.program->parts[static_cast<std::size_t>(solid.part)].is<parts::Domain>();
}

void ask_static(const Table& table, const Vec2& p, bool shapes_only, Answer& answer) {
    const Field& field = table.program->fixed;
    if (!shapes_only) {
        const Nearest found = nearest(field, p);
        answer.offer(found, field, found.gradient);
        return;
    }
    for (std::size_t i = 0; i < field.solids.size(); ++i) {
        if (!(field.solids[i].layers & ground_layer) || is_boundary(table, field.solids[i])) continue;
        const Nearest found = nearest_of_solid(field, static_cast<int>(i), p);
        answer.offer(found, field, found.gradient);
    }
}

void ask_mover(const Program& program, int index, const Vec2& p, Answer& answer) {
    const Mover& mover = program.movers[static_cast<std::size_t>(index)];
    const Similarity world_from_mover = world_from_resting_mover(program, index);
    const Nearest found = nearest(mover.field, world_from_mover.inverse() * p);
    answer.offer(found, mover.field, world_from_mover.direction(found.gradient));
}

void eval(const Options& options) {
    const Table table = open_table(options.file);
    const Program& program = *table.program;
    const std::vector<CsvRecord> records = value_or_stop(read_csv(options.points, "x,y"));

    Output out(options.out);
    out.write("x,y,distance,grad_x,grad_y,node,certified\n");
    for (const CsvRecord& record : records) {
        const Vec2 p(value_or_stop(csv_number(options.points, record, 0)), value_or_stop(csv_number(options.points, record, 1)));
        Answer answer;
        ask_static(table, p, options.shapes_only, answer);
        for (std::size_t i = 0; i < program.movers.size(); ++i) ask_mover(program, static_cast<int>(i), p, answer);
        const std::string node = answer.distance < infinity ? name_of(table.scene, answer.node) : "";
        out.write(fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{:d}\n", p.x(), p.y(), answer.distance, answer.gradient.x(),
                              answer.gradient.y(), node, answer.is_certified()));
    }
    out.finish();
}

}  // namespace

void add_eval(CLI::App& app, Exit& exit) {
    CLI::App* command = app.add_subcommand("eval", "Evaluate the signed distance of a table's solids at points");
    const auto options = std::make_shared<Options>();
    command->add_option("FILE", options->file, "Table file")->required();
    command->add_option("--points", options->points, "CSV with the header x,y, metres")->required();
    command->add_option("-o,--output", options->out, "CSV to write; stdout when not given");
    command->add_flag("--shapes-only", options->shapes_only, "Leave the domain out");
    command->callback([options, &exit] {
        eval(*options);
        exit = Exit::fine;
    });
}

}  // namespace pinfield::cli
