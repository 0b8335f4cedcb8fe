// Shader sources, without their first line: each compiles as GLSL 330 core and as GLSL 300 es.
#pragma once

namespace pinfield::editor::shaders {

/// Places are pixels of the canvas, y down, from its top left corner.
inline constexpr const char* quad_vertex = R"(
in vec2 place;
in vec2 picture;
in float extra;
uniform vec2 canvas;
out vec2 at;
out vec2 pixel;
out float more;
void main() {
    at = picture;
    pixel = place;
    more = extra;
    gl_Position = vec4(2.0 * place.x / canvas.x - 1.0, 1.0 - 2.0 * place.y / canvas.y, 0.0, 1.0);
}
)";

/// The static field and the movers. A color is looked up by material; light comes from the upper left and its shadow is
/// read from the distance field itself, a step towards the light. Preceded by isolines::isoline_color_source.
inline constexpr const char* field_fragment = R"(
in vec2 at;
in vec2 pixel;
in float more;
uniform sampler2D distances;
uniform isampler2D materials;
uniform vec3 palette[64];
uniform vec2 texels;
uniform vec2 light;            // in the picture's own frame, unit, towards the light, y up
uniform float metres_per_texel;
uniform float pixels_per_metre;
uniform vec2 world_corner;     // the canvas's top left
uniform vec2 table;            // size
uniform vec4 floor_low;
uniform vec4 floor_high;
uniform vec4 backdrop;
uniform vec4 rim;
uniform float shadow;          // how strong shadows are
uniform int mover;             // 1: only the solid and its shadow, over what is there
uniform int isolines;
uniform float spacing;         // of isolines, metres
uniform sampler2D underlay;
uniform vec2 underlay_corner;  // lower left, world
uniform vec2 underlay_size;    // metres
uniform int underlay_turns;    // quarters, to the left
uniform float underlay_opacity;
uniform int underlay_over;     // 1: over the table, too
out vec4 color;

float distance_at(vec2 p) { return texture(distances, p).r; }

float rounded_box(vec2 p, vec2 half_size, float r) {
    vec2 q = abs(p) - half_size + r;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - r;
}

vec3 solid_color(vec3 base, float d, float slope) {
    // A bevel: bright where the edge faces the light, dark on the other side, flat further in.
    float depth = -d * 1000.0;
    float bevel = exp(-max(depth - 0.2, 0.0) / 0.9);
    vec3 c = base * (0.94 + 0.10 * exp(-depth / 14.0));
    c += bevel * max(slope, 0.0) * vec3(0.30, 0.29, 0.27);
    c *= 1.0 - 0.42 * bevel * max(-slope, 0.0);
    return c;
}

/// The photograph's color at a place of the world, and how much of it is seen.
vec4 underlay_at(vec2 world) {
    vec2 own = (world - underlay_corner) / underlay_size - 0.5;
    vec2 edge = (0.5 - abs(own)) * underlay_size * pixels_per_metre;
    for (int i = 0; i < underlay_turns; ++i) own = vec2(own.y, -own.x);
    vec4 c = texture(underlay, vec2(0.5 + own.x, 0.5 - own.y));
    return vec4(c.rgb, c.a * underlay_opacity * clamp(0.5 + min(edge.x, edge.y), 0.0, 1.0));
}

void main() {
    float d = distance_at(at);
    vec2 step_x = vec2(1.0 / texels.x, 0.0), step_y = vec2(0.0, 1.0 / texels.y);
    vec2 g = vec2(distance_at(at + step_x) - distance_at(at - step_x), distance_at(at - step_y) - distance_at(at + step_y));
    float slope = dot(g, light) / max(length(g), 1e-9);
    ivec2 texel = ivec2(clamp(at * texels, vec2(0.0), texels - 1.0));
    int material = texelFetch(materials, texel, 0).r;
    vec3 base = palette[clamp(material, 0, 63)];
    float cover = clamp(0.5 - d * pixels_per_metre, 0.0, 1.0);
    vec2 towards_light = vec2(light.x, -light.y) / (texels * metres_per_texel);
    float shade = 0.52 * shadow * (1.0 - smoothstep(-0.0035, 0.0035, distance_at(at + 0.0075 * towards_light)));

    vec2 world = world_corner + vec2(pixel.x, -pixel.y) / pixels_per_metre;
    vec2 middle = 0.5 * table;
    if (mover == 1) {
        float alpha = max(cover, shade * 0.9);
        vec3 c = mix(vec3(0.0), solid_color(base, d, slope), cover);
        // What slides out of the table, such as a plunger that is drawn, goes under its frame.
        float within = clamp(0.5 - rounded_box(world - middle, middle, 0.006) * pixels_per_metre, 0.0, 1.0);
        color = within * vec4(c * cover, alpha);      // premultiplied
        return;
    }
    vec4 photo = underlay_at(world);
    if (isolines == 1) {
        // Beyond the table the field goes on for ever, but it is not what one looks at.
        float beyond = smoothstep(0.0, 0.05, rounded_box(world - middle, middle, 0.0));
        vec3 lines = mix(isoline_color(d, spacing, 1.0 / pixels_per_metre), backdrop.rgb, 0.88 * beyond);
        color = vec4(underlay_over == 1 ? mix(lines, photo.rgb, photo.a) : lines, 1.0);
        return;
    }
    float height = clamp(world.y / max(table.y, 1e-6), 0.0, 1.0);
    vec3 floor_color = mix(floor_low.rgb, floor_high.rgb, height);
    float across = (world.x - middle.x) / max(middle.x, 1e-6);
    floor_color *= 1.06 - 0.16 * across * across;
    floor_color = mix(floor_color, photo.rgb, photo.a);
    floor_color *= 1.0 - 0.30 * shadow * exp(-max(d, 0.0) / 0.006);   // light does not reach into corners
    floor_color *= 1.0 - shade;
    vec3 c = mix(floor_color, solid_color(base, d, slope), cover);

    // The cabinet: the table's rectangle with a rim, on the window's backdrop.
    float wide = 0.014;
    float outer = rounded_box(world - middle, middle + wide, wide + 0.006);
    float inner = rounded_box(world - middle, middle, 0.006);
    vec3 wood = rim.rgb * (1.0 + 0.25 * smoothstep(0.0, -wide, outer));
    wood += 0.10 * exp(-abs(outer) * pixels_per_metre / 1.2);
    float in_rim = clamp(0.5 + inner * pixels_per_metre, 0.0, 1.0);
    c = mix(c, wood, in_rim);
    float outside = clamp(0.5 + outer * pixels_per_metre, 0.0, 1.0);
    vec3 ground = backdrop.rgb * (1.0 - 0.45 * shadow * exp(-max(outer, 0.0) / 0.020));
    c = mix(c, mix(ground, photo.rgb, photo.a), outside);
    color = vec4(underlay_over == 1 ? mix(c, photo.rgb, photo.a) : c, 1.0);
}
)";

/// A ball seen from above: polished steel. `more` is its radius in pixels; 0 draws the shadow instead.
inline constexpr const char* ball_fragment = R"(
in vec2 at;
in vec2 pixel;
in float more;
uniform float ghost;
out vec4 color;
void main() {
    float r = length(at);
    if (more <= 0.0) {
        color = vec4(0.0, 0.0, 0.0, 0.55 * (1.0 - smoothstep(0.55, 1.0, r)));
        return;
    }
    float cover = clamp(0.5 + (1.0 - r) * more, 0.0, 1.0);
    float z = sqrt(max(1.0 - r * r, 0.0));
    vec3 n = vec3(at, z);
    // What a sphere of steel mirrors: a bright ceiling above, a dark table below the horizon, a soft lamp at the upper left.
    vec3 mirrored = reflect(vec3(0.0, 0.0, -1.0), n);
    float sky = smoothstep(-0.75, 0.95, mirrored.z + 0.35 * mirrored.y - 0.20 * mirrored.x);
    vec3 c = mix(vec3(0.16, 0.18, 0.22), vec3(0.80, 0.83, 0.87), sky);
    c = mix(c, vec3(0.46, 0.50, 0.56), 0.55 * (1.0 - smoothstep(0.0, 0.10, abs(mirrored.z - 0.12))));
    float lamp = max(dot(n, normalize(vec3(-0.42, 0.52, 0.74))), 0.0);
    c += 0.95 * pow(lamp, 60.0) + 0.16 * pow(lamp, 6.0);
    c *= 0.70 + 0.30 * smoothstep(0.0, 0.35, z);
    color = vec4(c * cover, cover) * (1.0 - ghost);
}
)";

/// Outline and light fill of one node's solid.
inline constexpr const char* outline_fragment = R"(
in vec2 at;
in vec2 pixel;
in float more;
uniform sampler2D distances;
uniform float pixels_per_metre;
uniform vec4 line;
uniform float width;           // pixels
uniform float fill;            // opacity of the inside
uniform float hatch;           // opacity of slanted stripes inside
out vec4 color;
void main() {
    float d = texture(distances, at).r * pixels_per_metre;
    float stroke = 1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.6, abs(d - 0.5));
    float inside = clamp(0.5 - d, 0.0, 1.0);
    float stripe = abs(fract((pixel.x + pixel.y) / 9.0) - 0.5) * 9.0;
    float ink = max(stroke * line.a, inside * (fill + hatch * clamp(stripe - 2.6, 0.0, 1.0)));
    color = vec4(line.rgb * ink, ink);
}
)";

}  // namespace pinfield::editor::shaders
