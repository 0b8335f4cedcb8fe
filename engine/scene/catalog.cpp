#include "engine/scene/catalog.h"

#include "engine/reflect/erase.h"
#include "engine/scene/node_common.h"
#include "engine/scene/part_list.h"
#include "engine/scene/part_traits.h"
#include "engine/scene/records.h"
#include "engine/sdf/nodes/box.h"
#include "engine/sdf/nodes/circle.h"
#include "engine/sdf/nodes/uneven_capsule.h"
#include "engine/sdf/register.h"

namespace pinfield {
namespace {

template <template <class> class N>
CustomaryShape shape_block(const N<double>& node) {
    const NodeType& type = sdf::built_in_type(N<double>::describe().meta.key);
    return {type.kernels, store(node), {}};
}

template <class P>
CustomaryShape customary_shape(const double* params) {
    const P node = load<P>(params);
    CustomaryShape out = shape_block(node.customary_shape());
    if constexpr (requires { node.part_from_shape(); }) out.part_from_shape = node.part_from_shape();
    return out;
}

template <class P>
const PartTraits& traits_of() {
    static const PartTraits traits = [] {
        PartTraits t{.role = P::role};
        if constexpr (requires { P::slides; }) t.slides = P::slides;
        if constexpr (requires { P::only_customary; }) t.only_customary.assign(P::only_customary.begin(), P::only_customary.end());
        if constexpr (requires(const P& p) { p.customary_shape(); }) t.customary_shape = customary_shape<P>;
        return t;
    }();
    return traits;
}

template <class... P>
void add_parts(Catalog& catalog, PartList<P...>) {
    const auto add = [&](NodeType type, const PartTraits& traits) {
        type.part = &traits;
        add_scene_type(catalog, std::move(type));
    };
    (add(node_type<P>(), traits_of<P>()), ...);
}

}  // namespace

const NodeType& add_scene_type(Catalog& catalog, NodeType type) {
    for (FieldType field : node_type<NodeCommon>().fields) {
        field.common = true;
        type.fields.push_back(std::move(field));
    }
    return catalog.add(std::move(type));
}

Catalog built_in_catalog() {
    Catalog nodes, catalog;
    sdf::add_built_in(nodes);
    for (const NodeType& type : nodes.types()) add_scene_type(catalog, type);
    add_parts(catalog, BuiltInParts{});
    catalog.add(node_type<TableInfo>());
    catalog.add(node_type<PhysicsSettings>());
    catalog.add(node_type<Material>());
    return catalog;
}

}  // namespace pinfield
