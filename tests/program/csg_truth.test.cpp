// The distance to CSG trees of line-and-arc shapes against an oracle that shares nothing with the lowering but the shapes' own
// outlines and fields: the nearest boundary point of a CSG solid is the foot on one of its shapes' lines and circles, or a point where
// two of these meet. Of all such candidates, nearest first, the first that lies on the solid's boundary is the truth; whether
// it does is found by asking the scene which of the places around it are inside.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/sdf/piece.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

constexpr double around = 1e-7;     ///< metres, at most, from a candidate to the places that are asked
constexpr double through = 1e-10;   ///< metres: curves nearer than this to a place run through it
constexpr double feeler = 1e-5;     ///< metres, along curves that touch: they part by its square, far more than rounding
constexpr double touching = 1e-13;  ///< square metres: below it a chord's half, whose root would magnify rounding, counts as 0

/// The line or circle that a piece of an outline is part of.
struct Curve {
    Vec2 at, along;     ///< of a line: a point and the unit direction
    double radius = 0;  ///< of a circle about `at`
    sdf::Piece piece{};

    double away(const Vec2& p) const { return std::fabs(radius > 0 ? length(p - at) - radius : cross(p - at, along)); }
    /// Is a point of the whole curve on the piece?
    bool has(const Vec2& p) const {
        if (radius > 0) return in_sweep(piece, p - at);
        return dot(p - at, along) >= -1e-12 && dot(p - at, along) <= length(piece.b - piece.a) + 1e-12;
    }
};

/// What a node says, ready to be asked often.
enum class Word { shape, images, unite, intersect, exclude, complement, subtract };
struct Item {
    Word word = Word::shape;
    const sdf::Kernels* kernels = nullptr;
    std::vector<double> block;
    Similarity parent_from_item, item_from_parent;
    std::vector<Similarity> images, back;
    std::vector<Item> children;
};

Item item_of(const Scene& scene, NodeId id) {
    const Node& node = *scene.find(id);
    Item item;
    item.kernels = node.type->kernels;
    std::vector<Value> values;
    for (int i = 0; i < node.type->own_fields; ++i) values.push_back(at(node.fields, i).value);
    item.block = pack(*node.type, values, item.kernels->derived_count);
    item.kernels->derive(item.block.data());
    item.parent_from_item = parent_from_local(node);
    item.item_from_parent = item.parent_from_item.inverse();
    if (item.kernels->images) item.images = item.kernels->images(item.block.data());
    for (const Similarity& image : item.images) item.back.push_back(image.inverse());
    for (const NodeId child : node.children) item.children.push_back(item_of(scene, child));
    static const std::pair<std::string_view, Word> words[] = {{"union", Word::unite},
                                                              {"intersection", Word::intersect},
                                                              {"xor", Word::exclude},
                                                              {"complement", Word::complement},
                                                              {"difference", Word::subtract}};
    if (item.kernels->form == sdf::Form::images) item.word = Word::images;
    for (const auto& [key, word] : words)
        if (node.type->key() == key) item.word = word;
    if (item.word == Word::shape && item.kernels->form != sdf::Form::shape) throw std::runtime_error("no word for this operation");
    return item;
}

/// Is p in the solid? By the words of the format, not by min and max.
bool inside(const Item& item, const Vec2& p) {
    const Vec2 local = item.item_from_parent * p;
    if (item.word == Word::shape) return item.kernels->distance(item.block.data(), local.x(), local.y()) < 0;
    if (item.word == Word::images)
        return std::any_of(item.back.begin(), item.back.end(),
                           [&](const Similarity& back) { return inside(item.children[0], back * local); });
    std::size_t in = 0;
    for (const Item& child : item.children) in += inside(child, local);
    switch (item.word) {
        case Word::unite: return in > 0;
        case Word::intersect: return in == item.children.size();
        case Word::exclude: return in % 2 == 1;
        case Word::complement: return in == 0;
        default: return in == 1 && inside(item.children[0], local);
    }
}

struct Oracle {
    Item root;
    std::vector<Curve> curves;
    std::vector<Vec2> corners;  ///< first all places where curves may meet, then those on the boundary
    static constexpr std::size_t most_curves = 60;

    Oracle(const Scene& scene, NodeId id) : root(item_of(scene, id)) {
        collect(root, Similarity{});
        if (curves.size() <= most_curves) find_corners();
        else corners.clear();
    }

    void collect(const Item& item, const Similarity& above) {
        if (curves.size() > most_curves) return;
        const Similarity here = above * item.parent_from_item;
        for (const Similarity& image : item.images)
            for (const Item& child : item.children) collect(child, here * image);
        if (item.images.empty())
            for (const Item& child : item.children) collect(child, here);
        if (item.word != Word::shape) return;
        sdf::Outline outline;
        item.kernels->outline(item.block.data(), outline);
        for (const sdf::Piece& piece : outline) {
            const Vec2 a = here * piece.a, b = here * piece.b;
            sdf::Piece moved = piece;
            moved.a = a, moved.b = b, moved.turn = here.mirrored ? -piece.turn : piece.turn;
            moved.centre = here * piece.centre;
            if (piece.is_arc()) curves.push_back({moved.centre, {0, 0}, here.scale * piece.radius, moved});
            else curves.push_back({a, (b - a) / length(b - a), 0, moved});
            corners.push_back(a);
        }
    }

    /// Angles at which curves leave a place, in order, and how far around it there is no other curve.
    struct Star {
        std::vector<double> angles;
        double room = around;
    };
    Star star_at(const Vec2& c) const {
        Star star;
        for (const Curve& curve : curves) {
            const double away = curve.away(c);
            if (away > through) {
                star.room = std::min(star.room, 0.25 * away);
                continue;
            }
            const Vec2 along = curve.radius > 0 ? perpendicular(c - curve.at) : curve.along;
            const double angle = std::atan2(along.y(), along.x());
            for (const double turned : {angle, angle > 0 ? angle - 3.14159265358979312 : angle + 3.14159265358979312})
                star.angles.push_back(turned);
        }
        std::sort(star.angles.begin(), star.angles.end());
        return star;
    }

    /// Where the curves through c are a little way from it, by their angle there.
    std::vector<std::pair<double, Vec2>> feelers_at(const Vec2& c) const {
        std::vector<std::pair<double, Vec2>> feelers;
        const auto feel = [&](const Vec2& p) { feelers.emplace_back(std::atan2(p.y() - c.y(), p.x() - c.x()), p); };
        for (const Curve& curve : curves)
            for (const double way : {-feeler, feeler}) {
                if (curve.radius > 0) {
                    const Vec2 ray = c - curve.at;
                    const double turn = way / curve.radius;
                    if (curve.away(c) > through) continue;
                    feel(curve.at + (curve.radius / length(ray)) * (std::cos(turn) * ray + std::sin(turn) * perpendicular(ray)));
                } else if (curve.away(c) <= through) {
                    feel(curve.at + (dot(c - curve.at, curve.along) + way) * curve.along);
                }
            }
        std::sort(feelers.begin(), feelers.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
        return feelers;
    }

    /// Inside and outside both reach c: asks halfway between the directions of the curves through it. Where curves touch there may be a
    /// cusp, which has no direction of its own: asks between them, a little way off.
    bool on_boundary(const Vec2& c) const {
        const auto [angles, room] = star_at(c);
        bool in = false, out = false;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 6.283185307179586;
            if (next - angles[i] < 1e-6) continue;
            const double middle = 0.5 * (angles[i] + next);
            (inside(root, c + room * Vec2(std::cos(middle), std::sin(middle))) ? in : out) = true;
        }
        if (in && out) return true;
        const std::vector<std::pair<double, Vec2>> feelers = feelers_at(c);
        for (std::size_t i = 0; i + 1 < feelers.size(); ++i) {
            const Vec2 &a = feelers[i].second, &b = feelers[i + 1].second;
            if (length(a - b) > 0.01 * feeler || length(a - b) < 1e-12) continue;
            (inside(root, 0.5 * (a + b)) ? in : out) = true;
        }
        return in && out;
    }

    void meet(const Curve& a, const Curve& b) {
        if (a.radius == 0 && b.radius == 0) {
            const double area = cross(a.along, b.along);
            if (std::fabs(area) > 1e-12) corners.push_back(a.at + (cross(b.at - a.at, b.along) / area) * a.along);
        } else if (a.radius == 0) {
            const Vec2 foot = a.at + dot(b.at - a.at, a.along) * a.along;
            const double square = b.radius * b.radius - dot(foot - b.at, foot - b.at);
            if (square < -touching) return;
            const double half = square > touching ? std::sqrt(square) : 0;
            for (const double side : {-half, half}) corners.push_back(foot + side * a.along);
        } else if (b.radius == 0) {
            meet(b, a);
        } else {
            const double apart = length(b.at - a.at);
            if (apart < 1e-12) return;
            const Vec2 way = (b.at - a.at) / apart;
            const double forward = 0.5 * (apart + (a.radius * a.radius - b.radius * b.radius) / apart),
                         square = a.radius * a.radius - forward * forward;
            if (square < -touching) return;
            const double half = square > touching ? std::sqrt(square) : 0;
            for (const double side : {-half, half}) corners.push_back(a.at + forward * way + side * perpendicular(way));
        }
    }

    void find_corners() {
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) meet(curves[i], curves[j]);
        std::erase_if(corners, [&](const Vec2& c) { return !c.allFinite() || !on_boundary(c); });
        std::sort(corners.begin(), corners.end(),
                  [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
        corners.erase(std::unique(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) { return length(a - b) < 1e-13; }),
                      corners.end());
    }

    /// Unsigned.
    double distance(const Vec2& p) const {
        std::vector<std::pair<double, Vec2>> candidates;
        double nearest_corner = infinity;
        for (const Vec2& corner : corners) nearest_corner = std::min(nearest_corner, length(p - corner));
        for (const Curve& curve : curves) {
            if (curve.radius > 0) {
                const Vec2 out = p - curve.at;
                const double rho = length(out);
                const Vec2 ray = rho > 0 ? Vec2(out / rho) : Vec2(1, 0);
                if (curve.has(curve.at + curve.radius * ray))
                    candidates.emplace_back(std::fabs(rho - curve.radius), curve.at + curve.radius * ray);
            } else {
                const Vec2 foot = curve.at + dot(p - curve.at, curve.along) * curve.along;
                if (curve.has(foot)) candidates.emplace_back(std::fabs(cross(p - curve.at, curve.along)), foot);
            }
        }
        std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [d, c] : candidates) {
            if (d >= nearest_corner) break;
            if (on_boundary(c)) return d;
        }
        return nearest_corner;
    }
};

struct Tally {
    int trees = 0, touching = 0, lowered = 0;
    long points = 0, certified = 0;
    double worst = 0, worst_over = 0;  ///< metres
    long wrong_signs = 0;
};

void judge_tree(std::uint64_t seed, bool snapped, int points, Tally& tally) {
    Scene scene(catalog());
    RandomTree tree(scene, seed, snapped, true);
    const NodeId root = tree.grow({}, 2 + static_cast<int>(seed % 5));
    const Oracle oracle(scene, root);
    if (oracle.corners.empty()) return;
    const ProgramPtr program = compiled(scene);
    const Field& field = program->fixed;
    ++tally.trees;
    tally.touching += snapped;
    tally.lowered += field.solids[0].lowered;
    CounterRng random(seed, 9);
    for (int i = 0; i < points; ++i) {
        const double x = random.in(-1.5, 1.5);
        const Vec2 p(x, random.in(-1.5, 1.5));
        const Nearest found = nearest_of_solid(field, 0, p);
        const double truth = oracle.distance(p), size = std::fabs(found.distance);
        ++tally.points;
        tally.certified += found.certified;
        tally.worst_over = std::max(tally.worst_over, size - truth);
        if (found.certified) tally.worst = std::max(tally.worst, std::fabs(size - truth));
        if (truth > 1e-9) tally.wrong_signs += (found.distance < 0) != inside(oracle.root, p);
        if (std::fabs(size - truth) > 1e-9 && found.certified)
            FAIL_CHECK("seed " << seed << (snapped ? " snapped" : "") << " at " << p.transpose() << ": " << found.distance << " for "
                               << truth);
    }
}

Tally judge(int trees, int points) {
    Tally tally;
    for (std::uint64_t seed = 1000; tally.trees < trees; ++seed) judge_tree(seed, seed % 2 == 0, points, tally);
    UNSCOPED_INFO(tally.trees << " trees, " << tally.touching << " snapped, " << tally.lowered << " lowered, " << tally.points
                              << " points, " << tally.certified << " certified, worst " << tally.worst << ", over " << tally.worst_over);
    CHECK(tally.touching >= trees / 4);
    CHECK(tally.lowered == tally.trees);
    CHECK(tally.certified == tally.points);
    CHECK(tally.worst < 1e-9);
    CHECK(tally.worst_over < 1e-9);
    CHECK(tally.wrong_signs == 0);
    return tally;
}

}  // namespace

TEST_CASE("distances to 200 random CSG trees are the true ones, inside and outside") { judge(200, 100); }

TEST_CASE("distances to 200 random CSG trees are the true ones at ten thousand points each", "[.]") { judge(200, 10000); }

// Five minutes: by name only.
TEST_CASE("distances to 200 random CSG trees are the true ones at a hundred thousand points each", "[.]") { judge(200, 100000); }
