#include "engine/physics/audit.h"

#include <algorithm>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/pose.h"
#include "engine/sdf/piece.h"

namespace pinfield {

namespace {

constexpr double most_samples = 100000;  // of one segment: 100 m of path at the usual spacing
constexpr int fine_samples = 16;         // between two samples, near solids whose boundary is not known as pieces: 1/16 mm apart

/// Where the movers are at a time since the world's start.
void place_movers(const World& world, double time, std::vector<double>& q) {
    q.clear();
    for (const MoverState& s : world.movers()) q.push_back(s.q);
    for (const MoverSegment& segment : world.mover_paths())
        if (time <= segment.start + segment.duration && time >= segment.start)
            at(q, segment.mover) = segment.at(time - segment.start);
}

/// Does the step from a to b pass through the piece from one side to the other?
bool crosses(const sdf::Piece& piece, const Vec2& a, const Vec2& b) {
    if (!piece.is_arc()) {
        const Vec2 d = piece.b - piece.a;
        const double sa = cross(d, a - piece.a), sb = cross(d, b - piece.a);
        const double ea = cross(b - a, piece.a - a), eb = cross(b - a, piece.b - a);
        return (sa > 0) != (sb > 0) && (ea > 0) != (eb > 0);
    }
    const double da = length(a - piece.centre) - piece.radius, db = length(b - piece.centre) - piece.radius;
    if ((da > 0) == (db > 0)) return false;
    return foot_on_piece(piece, a + (da / (da - db)) * (b - a)).distance < 1e-6;
}

bool crosses_boundary(const Field& field, const Vec2& a, const Vec2& b, LayerMask layers) {
    bool found = false;
    const int pieces = static_cast<int>(field.pieces.size());
    field.bvh.overlapping(Box2::of(a, b), [&](int entry) {
        if (entry >= pieces) {
            const int solid = at(field.tree_solids, entry - pieces);
            if ((at(field.solids, solid).layers & layers) == 0) return;
            for (int k = 1; k < fine_samples; ++k)
                found = found || nearest_of_solid(field, solid, a + (static_cast<double>(k) / fine_samples) * (b - a)).distance < 0;
        } else if (at(field.pieces, entry).layers & layers) {
            found = found || crosses(at(field.pieces, entry).piece, a, b);
        }
    });
    return found;
}

/// Where a ball was during the tick.
struct Track {
    std::vector<PathSegment> path;  ///< in order of time; none: it stood where it is
    Vec2 place{0, 0};
    LayerMask layers = ground_layer;
    Box2 box;                       ///< around all of it

    Vec2 at(double time) const {
        const auto after = std::find_if(path.begin(), path.end(), [&](const PathSegment& s) { return s.start > time; });
        if (after == path.begin()) return path.empty() ? place : path.front().position;
        const PathSegment& segment = *std::prev(after);
        return segment.at(std::min(time - segment.start, segment.duration));
    }
};

Track track_of(const World& world, const Ball& ball) {
    Track track{{}, ball.position, ball.layer, Box2::of(ball.position, ball.position)};
    for (const PathSegment& segment : world.paths()) {
        if (segment.ball != ball.id) continue;
        track.path.push_back(segment);
        const double strays = 0.125 * length(segment.acceleration) * segment.duration * segment.duration;  // a parabola off its chord
        track.box = track.box.merged(Box2::of(segment.position, segment.at(segment.duration)).grown(strays));
    }
    return track;
}

/// Over the tick: exact where both move straight, and sampled between the ends of parabolas.
double least_distance(const Track& a, const Track& b) {
    std::vector<double> times;
    for (const Track* track : {&a, &b})
        for (const PathSegment& segment : track->path) {
            times.push_back(segment.start);
            const int samples = segment.acceleration == Vec2(0, 0) ? 1 : 16;
            for (int k = 1; k <= samples; ++k) times.push_back(segment.start + segment.duration * k / samples);
        }
    if (times.empty()) return length(a.place - b.place);
    std::sort(times.begin(), times.end());
    double least = infinity;
    for (std::size_t k = 0; k < times.size(); ++k) {
        const Vec2 from = a.at(times[k]) - b.at(times[k]), to = k + 1 < times.size() ? Vec2(a.at(times[k + 1]) - b.at(times[k + 1])) : from;
        const Vec2 way = to - from;
        const double squared = dot(way, way), u = squared > 0 ? std::clamp(-dot(from, way) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, length(from + u * way));
    }
    return least;
}

}  // namespace

double overlap_of_balls(const World& world) {
    double most = 0;
    const double touch = 2 * world.program().physics.ball_radius;
    const std::span<const Ball> balls = world.balls();
    for (std::size_t i = 0; world.balls_collide() && i < balls.size(); ++i)
        for (std::size_t j = i + 1; j < balls.size(); ++j)
            if (is_on_table(balls[i]) && is_on_table(balls[j]) && share_layer(balls[i], balls[j])) most = std::max(most, touch - length(balls[i].position - balls[j].position));
    return most;
}

void Auditor::after_tick(const World& world) {
    for (const PathSegment& path : world.paths()) check(world, path);
    check_places(world);
    if (world.balls_collide()) check_pairs(world);
}

/// Where the tick leaves the balls: one that stands has no path, and one may have been moved by place.
void Auditor::check_places(const World& world) {
    const double r = world.program().physics.ball_radius;
    q_.clear();
    for (const MoverState& s : world.movers()) q_.push_back(s.q);
    for (const Ball& ball : world.balls()) {
        if (!is_on_table(ball)) continue;
        const double distance = gap_at(world.program(), q_, ball.position, ball.layer, 2 * r).distance;
        report_.worst_depth = std::max(report_.worst_depth, r - distance);
        const auto has_path = [&](const PathSegment& path) { return path.ball == ball.id; };
        if (distance < 0 && std::none_of(world.paths().begin(), world.paths().end(), has_path)) ++report_.crossings;
    }
}

void Auditor::check_pairs(const World& world) {
    std::vector<Track> tracks;
    for (const Ball& ball : world.balls())
        if (is_on_table(ball)) tracks.push_back(track_of(world, ball));
    const double r = world.program().physics.ball_radius;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        for (std::size_t j = i + 1; j < tracks.size(); ++j) {
            if ((tracks[i].layers & tracks[j].layers) == 0) continue;
            if (!tracks[i].box.grown(r).overlaps(tracks[j].box.grown(r))) continue;
            report_.worst_overlap = std::max(report_.worst_overlap, 2 * r - least_distance(tracks[i], tracks[j]));
        }
}

void Auditor::check(const World& world, const PathSegment& path) {
    ++report_.segments;
    const Program& program = world.program();
    const Ball* ball = world.find(path.ball);
    const LayerMask layers = ball ? ball->layer : ground_layer;
    const double r = program.physics.ball_radius;
    const double way = length(path.velocity) * path.duration + 0.5 * length(path.acceleration) * path.duration * path.duration;
    const int samples = static_cast<int>(std::clamp(std::ceil(way / spacing_), 8.0, most_samples));
    bool crossed = false;
    Vec2 before = path.position;
    double gap_before = 0;
    std::vector<double> q_before;
    for (int k = 0; k <= samples; ++k) {
        const double t = path.duration * (static_cast<double>(k) / samples);
        const Vec2 p = path.at(t);
        place_movers(world, path.start + t, q_);
        const double distance = gap_at(program, q_, p, layers, 2 * r).distance;
        report_.worst_depth = std::max(report_.worst_depth, r - distance);
        if (distance < 0) crossed = true;
        const double step = length(p - before);
        if (k > 0 && !crossed && std::min(distance, gap_before) < step + spacing_) {
            crossed = crosses_boundary(program.fixed, before, p, layers);
            for (std::size_t m = 0; m < program.movers.size() && !crossed; ++m) {
                const Mover& mover = program.movers[m];
                crossed = crosses_boundary(mover.field, pose_of(mover, q_before[m]).place_from_world(before),
                                           pose_of(mover, q_[m]).place_from_world(p), layers);
            }
        }
        before = p;
        gap_before = distance;
        q_before = q_;
    }
    if (crossed) ++report_.crossings;
}

}  // namespace pinfield
