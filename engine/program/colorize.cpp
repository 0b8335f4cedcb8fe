// A raster's colors on the CPU: what `pinfield render` writes. The editor shades solids in a way of its own; isolines look alike in both.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/core/at.h"
#include "engine/core/color.h"
#include "engine/program/isolines.h"
#include "engine/program/raster.h"

namespace pinfield {
namespace {

using Rgb = Eigen::Vector3f;  // linear light, 0..1

float smoothstep(float lo, float hi, float v) {
    const float t = std::clamp((v - lo) / (hi - lo), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}
Rgb mix(const Rgb& a, const Rgb& b, float t) { return a + (b - a) * t; }

/// sRGB transfer with an exponent of 2: close to the standard's curve, and the square root is exact on every machine.
Rgb from_srgb(Color c) {
    const Rgb v(static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255);
    return v.cwiseProduct(v);
}
void store(const Rgb& c, unsigned char* pixel) {
    for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<unsigned char>(255 * std::sqrt(std::clamp(c[i], 0.0f, 1.0f)) + 0.5f);
}

/// The theme: a night-blue playfield, slate walls. Blue against sand stays apart for every common color blindness.
const Rgb playfield_low = from_srgb({22, 30, 44}), playfield_high = from_srgb({36, 50, 70});
const Rgb wall = from_srgb({104, 121, 143});

struct Sampler {
    const Raster& raster;
    float pixel;  // metres

    float distance(int x, int y) const {
        x = std::clamp(x, 0, raster.width - 1);
        y = std::clamp(y, 0, raster.height - 1);
        return at(raster.distance, y * raster.width + x);
    }
    /// Gradient of the distance by central differences, y up.
    Eigen::Vector2f gradient(int x, int y) const {
        return Eigen::Vector2f(distance(x + 1, y) - distance(x - 1, y), distance(x, y - 1) - distance(x, y + 1)) / (2 * pixel);
    }
};

/// Space lies a little lower than the solids: they throw a soft shadow on it, longer below and to the right.
Rgb shade_outside(const Sampler& s, int x, int y, float d) {
    const float height = 1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(s.raster.height);
    const Rgb base = mix(playfield_low, playfield_high, height);
    const int shift = static_cast<int>(0.004f / s.pixel + 0.5f);  // the light comes from the upper left
    const float lit = s.distance(x - shift, y - shift);
    const float contact = 1 - 0.35f * (1 - smoothstep(0, 0.010f, d));
    const float cast = 1 - 0.45f * (1 - smoothstep(-0.003f, 0.006f, lit));
    return base * (contact * cast);
}

/// Solids have a rounded edge a few millimetres wide that catches the light, and are matt within.
Rgb shade_inside(const Sampler& s, int x, int y, float d, const Rgb& color) {
    const float edge = 1 - smoothstep(0, 0.005f, -d);
    const Eigen::Vector2f g = s.gradient(x, y);
    const float toward_light = (-0.6f * g.x() + 0.8f * g.y());
    const float depth = 1 - 0.32f * smoothstep(0.004f, 0.06f, -d);
    return color * (depth * (0.92f + 0.38f * edge * toward_light)) + Rgb::Constant(0.035f * edge * std::max(toward_light, 0.0f));
}

Rgb shaded(const Sampler& s, int x, int y, const std::vector<Rgb>& materials) {
    const std::size_t i = static_cast<std::size_t>(y * s.raster.width + x);
    const float d = s.raster.distance[i];
    const float solid = 1 - smoothstep(-0.5f * s.pixel, 0.5f * s.pixel, d);
    Rgb out = solid < 1 ? shade_outside(s, x, y, std::max(d, 0.0f)) : Rgb(0, 0, 0);
    if (solid > 0) {
        const int material = s.raster.material[i];
        const Rgb& color = material < 0 ? wall : at(materials, material);
        out = mix(out, shade_inside(s, x, y, std::min(d, 0.0f), color), solid);
    }
    return out;
}

}  // namespace

std::vector<unsigned char> shaded_picture(const Raster& raster, const Program& program) {
    std::vector<Rgb> materials;
    for (const MaterialRecord& material : program.materials) {
        const std::optional<Color> color = parse_color(material.color);
        materials.push_back(color ? from_srgb(*color) : wall);
    }
    const Sampler sampler{raster, static_cast<float>(raster.metres_per_pixel())};
    std::vector<unsigned char> image(3 * raster.distance.size());
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x)
            store(shaded(sampler, x, y, materials), image.data() + 3 * (y * raster.width + x));
    return image;
}

std::vector<unsigned char> isoline_picture(const Raster& raster, double spacing) {
    const auto pixel = static_cast<float>(raster.metres_per_pixel()), apart = static_cast<float>(spacing);
    std::vector<unsigned char> image;
    image.reserve(3 * raster.distance.size());
    for (const float d : raster.distance) {
        const isolines::vec3 color = isolines::isoline_color(d, apart, pixel);
        for (const float channel : {color.x, color.y, color.z}) image.push_back(static_cast<unsigned char>(255 * channel + 0.5f));
    }
    return image;
}

}  // namespace pinfield
