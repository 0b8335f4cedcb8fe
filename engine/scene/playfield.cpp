#include "engine/scene/playfield.h"

#include <array>
#include <cmath>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/core/trig.h"

namespace pinfield {
namespace {

void set(Node& node, std::string_view key, Value value) {
    FieldSlot& slot = at(node.fields, *node.type->find_field(key));
    slot.value = std::move(value);
    slot.is_explicit = true;
}

/// A round place on the table that one obstacle has for itself.
struct Plot {
    Vec2 centre;
    double radius;
};

class PlayfieldGenerator {
public:
    PlayfieldGenerator(Scene& scene, int obstacles, std::uint64_t seed)
        : scene_(scene), random_(seed, 0), size_(0.5 * std::sqrt(obstacles / 200.0), std::sqrt(obstacles / 200.0)) {}

    void run(int obstacles) {
        set(scene_.table(), "size", size_);
        Node& domain = scene_.add(*scene_.catalog().find("domain"));
        Node& room = scene_.add(*scene_.catalog().find("box"), domain.id);
        set(room, "size", size_);
        set(room, "at", Vec2(0.5 * size_));
        // A bounded number of tries: a table too full for the last few obstacles has some fewer.
        for (int tries = 0; static_cast<int>(plots_.size()) < obstacles && tries < 400 * obstacles; ++tries) place_one();
    }

private:
    const NodeType& type(std::string_view key) const { return *scene_.catalog().find(key); }

    void place_one() {
        const int kind = static_cast<int>(plots_.size() % 10);
        const Vec2 centre = random_point({0, 0}, size_);
        const double turn = random_.in(0, 360);
        if (kind < 4) {
            const double radius = random_.in(0.003, 0.012);
            if (claim({centre, radius})) set(add("circle", centre), "radius", radius);
        } else if (kind < 7) {
            const double half = random_.in(0.008, 0.020), radius = random_.in(0.002, 0.004);
            if (!claim({centre, half + radius})) return;
            Node& node = add("capsule", centre);
            set(node, "length", 2 * half);
            set(node, "radius", radius);
            set(node, "turn", turn);
        } else if (kind < 9) {
            const Vec2 size = 2 * random_point({0.004, 0.004}, {0.014, 0.010});
            if (!claim({centre, 0.5 * length(size)})) return;
            Node& node = add("box", centre);
            set(node, "size", size);
            set(node, "turn", turn);
        } else {
            const double radius = random_.in(0.008, 0.014);
            const int corners = 3 + static_cast<int>(random_.uniform() * 4);
            if (!claim({centre, radius})) return;
            std::vector<Vec2> points;
            for (int i = 0; i < corners; ++i) {
                const double angle = turn + 360.0 * i / corners;
                points.emplace_back(radius * cosine_degrees(angle), radius * sine_degrees(angle));
            }
            set(add("polygon", centre), "points", points);
        }
    }

    /// x is drawn before y: as constructor arguments their order would be the compiler's choice.
    Vec2 random_point(const Vec2& lo, const Vec2& hi) {
        const double x = random_.in(lo.x(), hi.x());
        return {x, random_.in(lo.y(), hi.y())};
    }

    Node& add(std::string_view key, const Vec2& at) {
        Node& node = scene_.add(type(key));
        set(node, "at", at);
        return node;
    }

    /// Takes the plot when it is on the table and 2 mm from every other.
    bool claim(const Plot& plot) {
        const double r = plot.radius;
        if (plot.centre.x() < r || plot.centre.y() < r || plot.centre.x() > size_.x() - r || plot.centre.y() > size_.y() - r)
            return false;
        for (const Plot& other : plots_)
            if (length(other.centre - plot.centre) < other.radius + r + 0.002) return false;
        plots_.push_back(plot);
        return true;
    }

    Scene& scene_;
    CounterRng random_;
    Vec2 size_;
    std::vector<Plot> plots_;
};

}  // namespace

Scene playfield(std::shared_ptr<const Catalog> catalog, int obstacles, std::uint64_t seed) {
    Scene scene(std::move(catalog));
    set(scene.table(), "name", std::string("Generated playfield"));
    Node& elastic = scene.add_material("default");
    set(elastic, "restitution", 1.0);
    set(elastic, "friction", 0.0);
    PlayfieldGenerator(scene, obstacles, seed).run(obstacles);
    return scene;
}

}  // namespace pinfield
