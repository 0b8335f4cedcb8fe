#include "engine/sdf/simple_chain.h"

#include <algorithm>
#include <vector>

#include "engine/core/geometry.h"

namespace pinfield::sdf {
namespace {

struct Stretch {
    Vec2 a, b;
    double lo, hi;  // in x
};

int side(const Stretch& of, const Vec2& p) {
    const double area = cross(Vec2(of.b - of.a), Vec2(p - of.a));
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

bool crosses_or_overlaps(const Stretch& s, const Stretch& t) {
    if (std::max(s.a.y(), s.b.y()) < std::min(t.a.y(), t.b.y()) || std::max(t.a.y(), t.b.y()) < std::min(s.a.y(), s.b.y()))
        return false;
    const int ta = side(s, t.a), tb = side(s, t.b), sa = side(t, s.a), sb = side(t, s.b);
    if (ta * tb < 0 && sa * sb < 0) return true;
    if (ta != 0 || tb != 0 || sa != 0 || sb != 0) return false;
    const Vec2 along = s.b - s.a;  // on one line: they may share a point, not a stretch
    const double length2 = dot(along, along), u = dot(along, Vec2(t.a - s.a)), v = dot(along, Vec2(t.b - s.a));
    return std::min(length2, std::max(u, v)) > std::max(0.0, std::min(u, v));
}

}  // namespace

bool is_simple_chain(const double* xy, int count) {
    std::vector<Stretch> edges;
    for (int i = 0; i < count; ++i) {
        const int j = i + 1 == count ? 0 : i + 1;
        const Vec2 a(xy[2 * i], xy[2 * i + 1]), b(xy[2 * j], xy[2 * j + 1]);
        if (a != b) edges.push_back({a, b, std::min(a.x(), b.x()), std::max(a.x(), b.x())});
    }
    std::sort(edges.begin(), edges.end(), [](const Stretch& s, const Stretch& t) { return s.lo < t.lo; });
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size() && edges[j].lo <= edges[i].hi; ++j)
            if (crosses_or_overlaps(edges[i], edges[j])) return false;
    return true;
}

}  // namespace pinfield::sdf
