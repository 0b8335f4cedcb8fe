#include "tests/program/enclosure.h"

#include <catch2/catch.hpp>

#include <algorithm>

#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "engine/program/tree.h"
#include "engine/scene/playfield.h"
#include "tests/places.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

ProgramPtr gallery() {
    const Result<Reading> table = load_table(source_dir() + "/scenes/tables/gallery.yaml", catalog());
    REQUIRE(table);
    return compiled(table->scene);
}

Vec2 random_point(CounterRng& random, const Box2& box) {
    const double x = random.in(box.lo.x(), box.hi.x());
    return Vec2(x, random.in(box.lo.y(), box.hi.y())).cwiseMax(box.lo).cwiseMin(box.hi);
}

/// In the window, from a hundred thousandth of it wide to all of it.
Box2 random_box(CounterRng& random, const Box2& window) {
    const double share = std::pow(10, random.in(-5, 0));
    const Vec2 at = random_point(random, window);
    return Box2{at, at + share * window.size()}.intersected(window);
}

void check_samples(const Field& field, int op, const Box2& window, CounterRng& random, int boxes) {
    for (int i = 0; i < boxes; ++i) {
        const Box2 box = random_box(random, window);
        const sdf::Interval found = natural_enclosure(field, op, box);
        for (const Vec2& p : {box.lo, box.hi, random_point(random, box), random_point(random, box), random_point(random, box)}) {
            const double value = tree_value(field, op, p);
            INFO("op " << op << " at " << p.x() << ", " << p.y() << ": " << value << " in [" << found.lo << ", " << found.hi << "]");
            REQUIRE(found.contains(value));
        }
    }
}

/// The solids of a field that raster.cpp keeps for a tile, and those it drops: by the value at the centre, and how much it can change from
/// there, `trust` times as much as the Lipschitz constant says. 1 is the rule.
struct Pruned {
    std::vector<int> kept, dropped;  ///< ops
};
Pruned prune(const Field& field, const Box2& tile, double trust = 1) {
    const Vec2 centre = tile.centre();
    const double reach = 0.5 * length(tile.size());
    const auto claim = [&](const Solid& solid) { return at(field.ops, solid.root).exactness; };
    const auto change = [&](const Solid& solid) { return trust * reach * claim(solid).lipschitz; };
    double least = infinity;
    for (const Solid& solid : field.solids) least = std::min(least, tree_value(field, solid.root, centre) + change(solid));
    Pruned out;
    for (const Solid& solid : field.solids) {
        const double outside = solid.bounds.distance(centre);
        const bool is_far = claim(solid).outside == Side::exact && outside > 0 && outside - trust * reach > least;
        const bool drops = is_far || tree_value(field, solid.root, centre) - change(solid) > least;
        (drops ? out.dropped : out.kept).push_back(solid.root);
    }
    return out;
}

struct Verdicts {
    int proved = 0;   ///< solids that were rightly dropped for a tile: one that is kept is nearer, or as near, all over it
    int refuted = 0;  ///< wrongly: somewhere they are nearer than all that is kept
    int open = 0;     ///< intervals cannot tell
};

/// By quartering the tile until enclosures of both sides lie apart; what lies together after `depth` times is open.
class Judge {
public:
    Judge(const Field& field, const Pruned& pruned) : field_(field), pruned_(pruned), worst_(pruned.dropped.size(), Verdict::proved) {}

    Verdicts over(const Box2& tile, int depth) {
        std::vector<std::size_t> all(worst_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        look(tile, depth, all);
        const auto count = [&](Verdict v) { return static_cast<int>(std::count(worst_.begin(), worst_.end(), v)); };
        return {count(Verdict::proved), count(Verdict::refuted), count(Verdict::open)};
    }

private:
    enum class Verdict { proved, open, refuted };

    void look(const Box2& box, int depth, const std::vector<std::size_t>& suspects) {
        sdf::Interval kept(infinity);
        for (const int op : pruned_.kept) kept = min(kept, natural_enclosure(field_, op, box));
        std::vector<std::size_t> unsure;
        for (const std::size_t i : suspects) {
            const sdf::Interval dropped = natural_enclosure(field_, pruned_.dropped[i], box);
            if (dropped.hi < kept.lo) worst_[i] = Verdict::refuted;
            else if (dropped.lo < kept.hi) unsure.push_back(i);
        }
        if (unsure.empty()) return;
        if (depth == 0) {
            for (const std::size_t i : unsure) worst_[i] = std::max(worst_[i], Verdict::open);
            return;
        }
        const Vec2 c = box.centre();
        for (const Box2& quarter : {Box2{box.lo, c}, Box2{c, box.hi}, Box2{{box.lo.x(), c.y()}, {c.x(), box.hi.y()}},
                                    Box2{{c.x(), box.lo.y()}, {box.hi.x(), c.y()}}})
            look(quarter, depth - 1, unsure);
    }

    const Field& field_;
    const Pruned& pruned_;
    std::vector<Verdict> worst_;
};

/// Of tiles from 4 mm to 128 mm wide, in the window.
Verdicts judged(const Field& field, const Vec2& table, int tiles, double trust) {
    CounterRng random(31);
    Verdicts sum;
    for (int i = 0; i < tiles; ++i) {
        const double half = 0.002 * std::pow(2, random.in(0, 5));
        const Vec2 at = random_point(random, {{0, 0}, table});
        const Box2 tile{at - Vec2(half, half), at + Vec2(half, half)};
        const Pruned pruned = prune(field, tile, trust);
        const Verdicts v = Judge(field, pruned).over(tile, 5);
        sum = {sum.proved + v.proved, sum.refuted + v.refuted, sum.open + v.open};
        if (trust < 1) continue;
        for (int k = 0; k < 4; ++k) {
            const Vec2 p = random_point(random, tile);
            double least = infinity;
            for (const int op : pruned.kept) least = std::min(least, tree_value(field, op, p));
            for (const int op : pruned.dropped) REQUIRE(tree_value(field, op, p) >= least);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("the enclosure of a random tree over a box holds the values of all its ops at the box's points") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Scene scene(catalog());
        set(scene.table(), "size", Vec2(4, 4));
        RandomTree(scene, seed, seed % 2 == 0).grow({}, 3);
        const ProgramPtr program = compiled(scene);
        CounterRng random(seed);
        for (std::size_t op = 0; op < program->fixed.ops.size(); ++op)
            check_samples(program->fixed, static_cast<int>(op), Box2::centred(2, 2), random, 6);
    }
}

TEST_CASE("the enclosure of everything in the gallery holds its values") {
    const ProgramPtr program = gallery();
    CounterRng random(3);
    for (std::size_t op = 0; op < program->fixed.ops.size(); ++op) {
        const Box2& bounds = program->fixed.ops[op].bounds;
        const Box2 table{{0, 0}, program->size}, near = bounds.is_finite() && !bounds.is_empty() ? bounds.grown(0.01) : table;
        check_samples(program->fixed, static_cast<int>(op), near, random, 8);
    }
}

TEST_CASE("an enclosure narrows to the value as its box narrows to a point") {
    const ProgramPtr program = compiled(playfield(catalog(), 40));
    const Vec2 p(0.2, 0.3);
    for (const Solid& solid : program->fixed.solids) {
        double width = infinity;
        for (const double half : {1e-3, 1e-5, 1e-7}) {
            const double now = natural_enclosure(program->fixed, solid.root, Box2{p, p}.grown(half)).width();
            CHECK(now < 20 * half);
            CHECK(now < width);
            width = now;
        }
    }
}

TEST_CASE("what Lipschitz pruning drops for a tile is nearest nowhere in it, which intervals prove for most and refute for none") {
    struct Table {
        ProgramPtr program;
        double most_open;  ///< of all that is dropped: the gallery shows curves whose formulas iterate, of which intervals know little
    };
    const Table tables[] = {{gallery(), 0.2}, {compiled(playfield(catalog(), 80)), 0.01}};
    for (const auto& [program, most_open] : tables) {
        const Verdicts v = judged(program->fixed, program->size, 40, 1);
        CAPTURE(program->name, v.proved, v.refuted, v.open);
        CHECK(v.refuted == 0);
        CHECK(v.proved > 2000);
        CHECK(v.open <= most_open * (v.proved + v.open));
    }
}

TEST_CASE("intervals refute a pruning that trusts less change across a tile than there is") {
    const ProgramPtr program = compiled(playfield(catalog(), 80));
    CHECK(judged(program->fixed, program->size, 40, 0.3).refuted > 10);
}
