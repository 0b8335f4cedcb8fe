#include "engine/core/number_motion.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "engine/core/trig.h"

namespace pinfield {
namespace {

/// In [0, length). fmod is exact, and so the same everywhere.
double wrapped(double t, double length) {
    const double rest = std::fmod(t, length);
    return rest < 0 ? std::min(rest + length, std::nextafter(length, 0.0)) : rest;
}

double value_of(const SpinMotion& s, double t) { return s.from + s.rate * t; }

double value_of(const WaveMotion& w, double t) {
    // In degrees, where the quarters of a period are exact.
    const double turns = wrapped(t, w.period) / w.period + w.phase / two_pi;
    // std::lerp has its ends exactly and never goes beyond them.
    return std::lerp(w.low, w.high, (1 + sine_degrees(360 * turns)) / 2);
}

double value_of(const KeyedMotion& k, double t) {
    const MotionKey &first = k.keys.front(), &last = k.keys.back();
    if (k.loop && (t < first.time || t > last.time)) t = first.time + wrapped(t - first.time, last.time - first.time);
    if (t <= first.time) return first.value;
    if (t >= last.time) return last.value;
    const auto b = std::upper_bound(k.keys.begin(), k.keys.end(), t, [](double at, const MotionKey& key) { return at < key.time; });
    const auto a = b - 1;
    return std::lerp(a->value, b->value, (t - a->time) / (b->time - a->time));
}

double rate_of(const SpinMotion& s) { return std::fabs(s.rate); }
double rate_of(const WaveMotion& w) { return pi * std::fabs(w.high - w.low) / w.period; }
double rate_of(const KeyedMotion& k) {
    double steepest = 0;
    for (std::size_t i = 1; i < k.keys.size(); ++i)
        steepest = std::max(steepest, std::fabs(k.keys[i].value - k.keys[i - 1].value) / (k.keys[i].time - k.keys[i - 1].time));
    return steepest;
}

NumberMotion::Range range_of(const SpinMotion& s) {
    if (s.rate == 0) return {s.from, s.from};
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
NumberMotion::Range range_of(const WaveMotion& w) { return {std::min(w.low, w.high), std::max(w.low, w.high)}; }
NumberMotion::Range range_of(const KeyedMotion& k) {
    const auto less = [](const MotionKey& a, const MotionKey& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(k.keys.begin(), k.keys.end(), less);
    return {low->value, high->value};
}

NumberMotion negated_of(const SpinMotion& s) { return {SpinMotion{-s.rate, -s.from}}; }
NumberMotion negated_of(const WaveMotion& w) { return {WaveMotion{-w.low, -w.high, w.period, w.phase}}; }
NumberMotion negated_of(KeyedMotion k) {
    for (MotionKey& key : k.keys) key.value = -key.value;
    return {std::move(k)};
}

bool finite(std::initializer_list<double> numbers) { return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }); }

const char* fault_of(const SpinMotion& s) { return finite({s.rate, s.from}) ? nullptr : "a spin's numbers must be finite"; }
const char* fault_of(const WaveMotion& w) {
    if (!finite({w.low, w.high, w.period, w.phase})) return "a wave's numbers must be finite";
    return w.period > 0 ? nullptr : "a wave's period must be above 0";
}
const char* fault_of(const KeyedMotion& k) {
    if (k.keys.size() < 2) return "a motion by keys needs two of them at least";
    for (std::size_t i = 0; i < k.keys.size(); ++i) {
        if (!finite({k.keys[i].time, k.keys[i].value})) return "the numbers of keys must be finite";
        if (i > 0 && !(k.keys[i].time > k.keys[i - 1].time)) return "each key must be later than the one before";
    }
    // A jump has no rate, and nothing that a ball may lie on can jump.
    if (k.loop && k.keys.front().value != k.keys.back().value) return "a loop must end with the value that it began with";
    return nullptr;
}

}  // namespace

double NumberMotion::value_at(double t) const {
    return std::visit([&](const auto& m) { return value_of(m, t); }, kind);
}
double NumberMotion::rate_bound() const {
    return std::visit([](const auto& m) { return rate_of(m); }, kind);
}
NumberMotion::Range NumberMotion::range() const {
    return std::visit([](const auto& m) { return range_of(m); }, kind);
}
NumberMotion NumberMotion::negated() const {
    return std::visit([](const auto& m) { return negated_of(m); }, kind);
}
std::optional<std::string> NumberMotion::fault() const {
    const char* words = std::visit([](const auto& m) { return fault_of(m); }, kind);
    return words ? std::optional<std::string>(words) : std::nullopt;
}

}  // namespace pinfield
