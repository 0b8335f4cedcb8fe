#include "tests/conformance/sheet/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>
#include <vector>

#include "engine/core/at.h"
#include "engine/core/numbers.h"
#include "engine/core/rng.h"
#include "tests/conformance/parameters.h"

namespace pinfield::conformance {
namespace {

constexpr std::string_view head = "node,double ns,packet ns,instruction set";
constexpr int count = 4096;  // points: they and their results stay in the cache

struct Input {
    std::vector<double> a, b;
    std::vector<float> float_a, float_b;
};

/// Points in and around the subject; their coordinates serve as field values, too.
Input input_of(const Subject& subject) {
    Input out;
    CounterRng rng(3);
    const double reach = 1.5 * subject.extent();
    for (int i = 0; i < count; ++i) {
        out.a.push_back(rng.in(-reach, reach));
        out.b.push_back(rng.in(-reach, reach));
    }
    out.float_a.assign(out.a.begin(), out.a.end());
    out.float_b.assign(out.b.begin(), out.b.end());
    return out;
}

/// Of this process alone: a busy machine would count in the wall clock's.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Nanoseconds a point of one run over all points.
template <class Run>
double nanoseconds(Run run) {
    std::vector<double> times;
    for (int batch = 0; batch < 11; ++batch) {
        int runs = 0;
        const double start = cpu_seconds();
        double now = start;
        for (; now < start + 2e-3; now = cpu_seconds(), ++runs) run();
        times.push_back(1e9 * (now - start) / (static_cast<double>(runs) * count));
    }
    std::nth_element(times.begin(), times.begin() + 5, times.end());
    return times[5];
}

std::optional<double> time_in_double(const Subject& subject, const Input& in) {
    const sdf::Kernels& k = subject.kernels();
    const double* params = subject.params();
    volatile double kept = 0;  // so that no compiler takes the work away
    const auto time = [&](auto&& one) {
        return nanoseconds([&] {
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i) sum += one(in.a[i], in.b[i]);
            kept = sum;
        });
    };
    switch (k.form) {
        case sdf::Form::shape: return time([&](double x, double y) { return k.distance(params, x, y); });
        case sdf::Form::fold: return time([&](double a, double b) { return k.combine(params, a, b); });
        case sdf::Form::modify: return time([&](double a, double) { return k.modify(params, a); });
        case sdf::Form::warp:
            return time([&](double x, double y) {
                const Vec2 q = k.warp(params, {x, y});
                return q.x() + q.y() + k.lift(params, {x, y});
            });
        default: return {};
    }
}

/// Kernels that change their input get a fresh copy each time, whose cost is small: over and over again, a stretch would end in denormals.
std::optional<double> time_in_packets(const Subject& subject, const Input& in, sdf::Isa isa) {
    const sdf::PacketKernels& k = at(subject.kernels().packets, isa);
    std::vector<float> a = in.float_a, b = in.float_b, out(count);
    if (k.distance) return nanoseconds([&] { k.distance(subject.params(), {}, a.data(), b.data(), out.data(), count); });
    if (k.combine)
        return nanoseconds([&] {
            a = in.float_a;
            k.combine(subject.params(), a.data(), b.data(), count);
        });
    if (k.warp)
        return nanoseconds([&] {
            a = in.float_a, b = in.float_b;
            k.warp(subject.params(), a.data(), b.data(), out.data(), count);
        });
    return {};
}

/// Two digits: the third is noise.
std::string number(const std::optional<double>& ns) {
    if (!ns) return "";
    return *ns < 10 ? fmt::format("{:.1f}", *ns) : fmt::format("{:.0f}", *ns);
}

}  // namespace

Timing time_of(const Catalog& catalog, const NodeType& type) {
    const Subject subject = subjects_of(catalog, type, defaults_of(type)).front();
    const Input in = input_of(subject);
    sdf::Isa isa = sdf::best_isa();
    const sdf::PacketKernels& best = at(subject.kernels().packets, isa);
    if (!best.distance && !best.combine && !best.warp) isa = sdf::Isa::sse2;
    Timing out{time_in_double(subject, in), time_in_packets(subject, in, isa), {}};
    if (out.in_packets) out.isa = isa == sdf::Isa::avx2 ? "avx2" : "sse2";
    return out;
}

std::string csv_of(const Catalog& catalog, const Timings& timings) {
    std::string out = fmt::format("{}\n", head);
    for (const NodeType& type : catalog.types())
        if (const auto found = timings.find(type.key()); found != timings.end())
            out += fmt::format("{},{},{},{}\n", type.key(), number(found->second.in_double),
                               number(found->second.in_packets), found->second.isa);
    return out;
}

Result<Timings> read_timings(const std::string& csv) {
    Timings out;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    if (line != head) return failure(fmt::format("the first line is not \"{}\"", head));
    while (std::getline(lines, line)) {
        std::istringstream cells(line + ",");
        std::string key, in_double, in_packets, isa;
        std::getline(cells, key, ',');
        std::getline(cells, in_double, ',');
        std::getline(cells, in_packets, ',');
        std::getline(cells, isa, ',');
        const auto one = Timing{parse_number(in_double), parse_number(in_packets), isa};
        if (one.in_double.has_value() == in_double.empty() || one.in_packets.has_value() == in_packets.empty())
            return failure(fmt::format("\"{}\" holds no timing", line));
        out.emplace(key, one);
    }
    return out;
}

}  // namespace pinfield::conformance
