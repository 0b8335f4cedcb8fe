// pinfield simulate FILE: plays a table without a window and says what became of the balls.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/cli/command.h"
#include "engine/cli/csv.h"
#include "engine/cli/json.h"
#include "engine/cli/output.h"
#include "engine/cli/quantity_option.h"
#include "engine/cli/recorders.h"
#include "engine/cli/table.h"
#include "engine/core/at.h"
#include "engine/core/hash.h"
#include "engine/core/shown.h"
#include "engine/game/simulation.h"
#include "engine/game/starts.h"
#include "engine/physics/scatter.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string file, trace, events, inputs, integrator;
    std::optional<double> seconds, speed, restitution, step;
    std::optional<int> balls;
    std::uint64_t seed = 1;
    std::vector<std::string> launches;
    bool audit = false, json = false, no_sweep = false, demo = false;
};

constexpr std::size_t most_changes = 1'000'000;  // of inputs: 24 MB

struct Launch {
    Vec2 at{0, 0}, velocity{0, 0};
};

/// "x,y,vx,vy" as four numbers, units allowed; what is wrong with it, or "".
std::string why_invalid_launch(const std::string& text, Launch* launch = nullptr) {
    const Unit units[4] = {Unit::metre, Unit::metre, Unit::metre_per_second, Unit::metre_per_second};
    double values[4] = {};
    if (const auto commas = std::count(text.begin(), text.end(), ','); commas != 3)
        return fmt::format("\"{}\" has {} {}; a launch has four: x,y,vx,vy", text, commas + 1, commas == 0 ? "number" : "numbers");
    std::size_t begin = 0;
    for (int i = 0; i < 4; ++i) {
        const std::size_t end = i < 3 ? text.find(',', begin) : text.size();
        const std::string complaint = why_invalid_quantity(text.substr(begin, end - begin), units[i], from(-1e6), to(1e6), &values[i]);
        if (!complaint.empty()) return complaint;
        begin = end + 1;
    }
    if (launch) *launch = {{values[0], values[1]}, {values[2], values[3]}};
    return "";
}

/// Edges of the table's inputs, in order of ticks.
std::vector<InputChange> read_inputs(const std::string& path, const Program& program) {
    std::vector<InputChange> changes;
    if (path.empty()) return changes;
    CsvReader lines = value_or_stop(CsvReader::open(path, "tick,input,value"));
    for (CsvRecord record; value_or_stop(lines.next(record));) {
        const auto stop = [&](const std::string& message) {
            throw Stop{ExitCode::failed, fmt::format("{}:{}: {}", path, record.line, message), ""};
        };
        if (changes.size() == most_changes) stop(fmt::format("more than {} presses and releases", most_changes));
        const double tick = value_or_stop(csv_number(path, record, 0));
        if (tick < 0 || tick > 1e15 || tick != std::floor(tick)) stop(fmt::format("\"{}\" is no tick", record.cells[0]));
        const auto input = std::find(program.inputs.begin(), program.inputs.end(), record.cells[1]);
        if (input == program.inputs.end())
            stop(fmt::format("the table has no input \"{}\"; it has {}", record.cells[1],
                             program.inputs.empty() ? "none" : fmt::format("{}", fmt::join(program.inputs, ", "))));
        const double value = value_or_stop(csv_number(path, record, 2));
        if (value != 0 && value != 1) stop(fmt::format("\"{}\" is neither 1 (pressed) nor 0 (released)", record.cells[2]));
        changes.push_back({static_cast<std::int64_t>(tick), static_cast<int>(input - program.inputs.begin()), value});
    }
    std::stable_sort(changes.begin(), changes.end(), [](const InputChange& a, const InputChange& b) { return a.tick < b.tick; });
    return changes;
}

/// Every input once a second, each a tenth of a second after the one before it: long enough for a plunger, often enough for flippers.
std::vector<InputChange> demo_inputs(const World& world, double seconds) {
    const int inputs = static_cast<int>(world.program().inputs.size());
    const auto tick = [&](double time) { return static_cast<std::int64_t>(std::llround(time / world.step_length())); };
    std::vector<InputChange> changes;
    for (int second = 0; second < seconds && changes.size() < most_changes; ++second)
        for (int input = 0; input < inputs; ++input) {
            const double pressed = second + 0.1 * (input % 5);
            changes.push_back({tick(pressed), input, 1});
            changes.push_back({tick(pressed + 0.5), input, 0});
        }
    std::stable_sort(changes.begin(), changes.end(), [](const InputChange& a, const InputChange& b) { return a.tick < b.tick; });
    return changes;
}

World world_of(const Table& table, const Options& options) {
    WorldOptions how;
    how.seed = options.seed;
    how.restitution = options.restitution;
    how.step = options.step;
    how.sweep = !options.no_sweep;
    how.balls_collide = !options.balls;
    if (!options.integrator.empty())
        how.integrator = options.integrator == "ballistic" ? Integrator::ballistic : Integrator::symplectic_euler;
    World world(table.program, how);
    if (options.balls) {
        const int placed = scatter_balls(world, *options.balls, options.speed.value_or(1), options.seed);
        if (placed < *options.balls)
            throw Stop{ExitCode::wrong, fmt::format("{}: only {} of {} balls found free space", options.file, placed, *options.balls), ""};
    }
    for (const std::string& text : options.launches) {
        Launch launch;
        why_invalid_launch(text, &launch);
        if (const auto found = impossible_start(*table.program, table.scene, launch.at, ground_layer, {}))
            throw Stop{ExitCode::wrong, fmt::format("--launch {}: {}{}{}", text, found->message, found->hint.empty() ? "" : "; ", found->hint), ""};
        world.add_ball(launch.at, launch.velocity);
    }
    if (!options.balls && options.launches.empty()) world.add_spawned_balls();
    if (options.demo && world.balls().empty()) scatter_balls(world, 1, 0, options.seed);
    return world;
}

JsonObject json_of(const SimulationSummary& summary, const std::string& table) {
    JsonObject counts;
    for (int kind = 0; kind < event_kinds; ++kind)
        if (const auto count = at(summary.events, kind)) counts.add(name(static_cast<EventKind>(kind)), count);
    JsonObject json;
    json.add("table", table).add("ticks", summary.ticks).add("balls", summary.balls);
    json.add("wall_seconds", summary.wall_seconds).add("ball_steps_per_second", summary.ball_steps_per_second);
    json.add("escaped", summary.escaped).add("drained", summary.drained).add("max_penetration", summary.max_penetration);
    json.add("max_overlap", summary.max_overlap).add("capped_ticks", summary.capped_ticks).add("capped_queries", summary.capped_queries);
    json.add("energy_first", summary.energy_first).add("energy_last", summary.energy_last);
    json.add("events", counts).add("state_hash", hex16(summary.state_hash));
    if (summary.audit)
        json.add("audit", JsonObject()
                              .add("segments", summary.audit->segments)
                              .add("worst_depth", summary.audit->worst_depth)
                              .add("worst_overlap", summary.audit->worst_overlap)
                              .add("crossings", summary.audit->crossings));
    return json;
}

std::string text_of(const SimulationSummary& summary, const std::string& table, double step) {
    std::string text = fmt::format("{}: {} {}, {} ticks ({:g} s) in {:.3f} s: {:.3g} ball-steps/s\n", shown(table), summary.balls,
                                   summary.balls == 1 ? "ball" : "balls", summary.ticks, static_cast<double>(summary.ticks) * step,
                                   summary.wall_seconds, summary.ball_steps_per_second);
    text += fmt::format("  escaped         {}\n  drained         {}\n  max penetration {:.3g} m, of two balls {:.3g} m\n", summary.escaped,
                        summary.drained, summary.max_penetration, summary.max_overlap);
    text += fmt::format("  cut short       {} ball-ticks, {} searches\n", summary.capped_ticks, summary.capped_queries);
    const auto times = [&](EventKind kind) { return at(summary.events, kind); };
    text += fmt::format("  out of play     {} jammed, {} held back, {} stuck, {} quarantined\n", times(EventKind::jam), times(EventKind::held_back),
                        times(EventKind::stuck), times(EventKind::quarantine));
    text +=
        fmt::format("  energy          {:.9g} J at first, {:.9g} J at last\n  events         ", summary.energy_first, summary.energy_last);
    for (int kind = 0; kind < event_kinds; ++kind)
        if (const auto count = at(summary.events, kind)) text += fmt::format(" {} {}", name(static_cast<EventKind>(kind)), count);
    text += fmt::format("\n  state hash      {}\n", hex16(summary.state_hash));
    if (summary.audit)
        text += fmt::format("  audit           {} segments, worst depth {:.3g} m, of two balls {:.3g} m, {} crossings\n", summary.audit->segments,
                            summary.audit->worst_depth, summary.audit->worst_overlap, summary.audit->crossings);
    return text;
}

void run(const Options& options) {
    for (const std::string& output : {options.trace, options.events}) refuse_overwriting(output, {options.file, options.inputs});
    refuse_sharing(options.trace, options.events);
    const Table table = open_table(options.file, {options.trace, options.events});
    Game game(world_of(table, options), parents_of(table.scene));
    Recorder recorder(table.scene, options.trace, options.events);
    SimulationOptions how;
    how.seconds = options.seconds.value_or(10);
    how.audit = options.audit;
    how.inputs = options.demo ? demo_inputs(game.world(), how.seconds) : read_inputs(options.inputs, *table.program);
    how.observer = &recorder;
    recorder.start(game.world());
    const SimulationSummary summary = simulate(game, how);
    recorder.finish();
    const std::string name = table.program->name.empty() ? options.file : table.program->name;
    const std::string text = options.json ? json_of(summary, name).text() + "\n" : text_of(summary, name, game.world().step_length());
    // A stream of data stays one: whoever reads it does not want a summary behind it.
    is_stdout(options.trace) || is_stdout(options.events) ? tell(text) : print(text);
}

/// CLI11 would wrap a sign and saturate what is too large.
std::string why_invalid_seed(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    return error == std::errc() && end == text.data() + text.size() ? "" : fmt::format("{} is no whole number from 0 to 2^64 - 1", text);
}

}  // namespace

void add_simulate(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("simulate", "Play a table without a window");
    const auto options = std::make_shared<Options>();
    command.option("FILE", options->file, "Table file").required().offer(Offer::Kind::tables);
    add_quantity(command, "--seconds", options->seconds, Unit::second, from(0), to(1e6), "How long, in the table's time (10)");
    const Option balls = command.option("--balls", options->balls, "Scatter this many balls that ignore each other, in place of the spawns")
                             .range(0, 1'000'000);
    add_quantity(command, "--speed", options->speed, Unit::metre_per_second, from(0), to(1e6), "Of the scattered balls, m/s (1)")
        .needs(balls);
    command.option("--seed", options->seed, "Of everything random: a whole number from 0 to 2^64 - 1")
        .check(why_invalid_seed)
        .show_default();
    command.option("--launch", options->launches, "Add a ball x,y,vx,vy in place of the spawns; may be repeated")
        .one_at_a_time()
        .check([](const std::string& text) { return why_invalid_launch(text); });
    add_quantity(command, "--restitution", options->restitution, Unit::none, from(0), to(1),
                 "Set every restitution, and falloff, friction, scatter and kicks to 0");
    command.option("--integrator", options->integrator, "In place of the table's: symplectic_euler or ballistic")
        .one_of({"symplectic_euler", "ballistic"});
    add_quantity(command, "--step", options->step, Unit::second, from(1e-6), to(0.1), "Length of a tick in place of the table's");
    command.flag("--audit", options->audit, "Check every stretch of path densely against the true distance");
    command.option("--trace", options->trace, "Write tick,ball,x,y,vx,vy,spin as CSV; - for stdout, the summary then on stderr")
        .check(why_no_output)
        .offer(Offer::Kind::files);
    command.option("--events", options->events, "Write what happens as JSON lines; likewise").check(why_no_output).offer(Offer::Kind::files);
    const Option inputs = command.option("--inputs", options->inputs, "CSV tick,input,value: a line per press or release").offer(Offer::Kind::files);
    command.flag("--demo", options->demo, "Press the table's inputs by turns, and drop a ball where it has no spawn").excludes(inputs);
    command.flag("--json", options->json, "Print the summary as JSON");
    command.flag("--no-sweep", options->no_sweep, "").hidden();  // for tests of the auditor: balls tunnel
    command.callback([options, &exit] {
        run(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
