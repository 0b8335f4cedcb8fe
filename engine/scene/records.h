// What a table says beside its scene: its own data, its physics, its materials.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "engine/reflect/describe.h"

namespace pinfield {

/// The playing surface: x to the right, y up the slope, origin at the bottom left.
struct TableInfo {
    std::string name;
    std::string author;
    Point<double> size{0.52, 1.06};
    double slope = 6.5;

    static constexpr auto describe() {
        using T = TableInfo;
        return record<T>(
            {.key = "table", .doc = "The table itself."},
            fields(field("name", &T::name, {.doc = "Title of the table."}), field("author", &T::author, {.doc = "Who made it."}),
                   field("size", &T::size,
                         {.unit = Unit::metre,
                          .min = above(0),
                          .max = to(100),
                          .step = 0.01,
                          .doc = "Width and height; the domain of a table that has no domain node."}),
                   field("slope", &T::slope,
                         {.unit = Unit::degree,
                          .min = from(0),
                          .max = to(90),
                          .step = 0.1,
                          .doc = "Inclination; gravity in the plane is 9.81 m/s^2 times its sine."})));
    }
};

enum class Integrator : unsigned char { symplectic_euler, ballistic };
constexpr std::array<std::string_view, 2> choice_names(Integrator) { return {"symplectic_euler", "ballistic"}; }
enum class ContactModel : unsigned char { impulse };
constexpr std::array<std::string_view, 1> choice_names(ContactModel) { return {"impulse"}; }
enum class BallShape : unsigned char { disc, sphere };
constexpr std::array<std::string_view, 2> choice_names(BallShape) { return {"disc", "sphere"}; }

struct PhysicsSettings {
    double step = 0.001;
    Integrator integrator = Integrator::symplectic_euler;
    ContactModel contact = ContactModel::impulse;
    double ball_radius = 0.0135;
    double ball_mass = 0.08;
    double ball_restitution = 0.8;
    BallShape ball_inertia = BallShape::disc;
    bool ball_rolls = false;
    double rolling_resistance = 0;
    double tolerance = 1e-7;
    double rest_speed = 0.005;

    static constexpr auto describe() {
        using P = PhysicsSettings;
        return record<P>(
            {.key = "physics", .doc = "How the table is simulated."},
            fields(field("step", &P::step,
                         {.unit = Unit::second, .min = from(1e-6), .max = to(0.1), .step = 0.0001, .doc = "Length of a tick."}),
                   field("integrator", &P::integrator, {.doc = "symplectic_euler: straight within a tick. ballistic: exact parabolas."}),
                   field("contact", &P::contact, {.doc = "Contact model."}),
                   field("ball_radius", &P::ball_radius,
                         {.unit = Unit::metre, .min = above(0), .max = to(1), .step = 0.0005, .doc = "Radius of the balls."}),
                   field("ball_mass", &P::ball_mass, {.unit = Unit::kilogram, .min = above(0), .step = 0.001, .doc = "Mass of the balls."}),
                   field("ball_restitution", &P::ball_restitution,
                         {.min = from(0), .max = to(1), .step = 0.01, .doc = "Coefficient of restitution between balls."}),
                   field("ball_inertia", &P::ball_inertia,
                         {.doc = "What a ball is where it turns. disc: m r^2 / 2. sphere: 2 m r^2 / 5."}),
                   field("ball_rolls", &P::ball_rolls,
                         {.doc = "The ball rolls on the playfield: turning takes its share of what it falls, and gravity in the plane counts "
                                 "2/3 for a disc, 5/7 for a sphere. Otherwise it glides."}),
                   field("rolling_resistance", &P::rolling_resistance,
                         {.min = from(0),
                          .max = to(1),
                          .step = 0.001,
                          .doc = "Of the playfield: the share of the ball's weight on it that it takes to keep the ball moving. Steel on lacquer: 0.002."}),
                   field("tolerance", &P::tolerance,
                         {.unit = Unit::metre, .min = above(0), .max = to(0.001), .doc = "Gap at which a ball counts as touching."}),
                   field("rest_speed", &P::rest_speed,
                         {.unit = Unit::metre_per_second,
                          .min = from(0),
                          .step = 0.001,
                          .doc = "Impacts slower than this no longer bounce (unless restitution is 1)."})));
    }
};

/// The surface decides a contact; the ball's own material does not blend in.
struct Material {
    double restitution = 0.3;
    double falloff = 0;
    double tangential = 0;
    double friction = 0.3;
    double scatter = 0;
    std::string color;

    static constexpr auto describe() {
        using M = Material;
        return record<M>(
            {.key = "material", .doc = "How a surface answers a ball."},
            fields(
                field("restitution", &M::restitution,
                      {.min = from(0), .max = to(1), .step = 0.01, .doc = "Coefficient of restitution e0 of a slow impact."}),
                field("falloff", &M::falloff,
                      {.unit = Unit::seconds_per_metre, .min = from(0), .step = 0.01, .doc = "e(v) = e0 / (1 + falloff v)."}),
                field("tangential", &M::tangential,
                      {.min = from(-1),
                       .max = to(1),
                       .step = 0.01,
                       .doc = "Tangential coefficient of restitution: 1 frictionless, 0 stops the slip, -1 reverses it."}),
                field("friction", &M::friction,
                      {.min = from(0), .step = 0.01, .doc = "Coulomb coefficient that caps the tangential impulse."}),
                field("scatter", &M::scatter,
                      {.unit = Unit::degree,
                       .min = from(0),
                       .max = to(45),
                       .step = 0.5,
                       .doc = "Largest random turn of the outgoing direction."}),
                field("color", &M::color, {.meaning = Meaning::color, .doc = "How it is drawn: a CSS name or a quoted #rgb or #rrggbb."})));
    }
};

}  // namespace pinfield
