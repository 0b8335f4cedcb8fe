// Which ways an op's field may rise near a point: whether its zero line can do anything there but run through once.
#pragma once
#include <map>
#include <vector>

#include "engine/program/program.h"

namespace pinfield {

/// Directions between two of them, less than half a turn apart; or none, or more than that.
class Fan {
public:
    static Fan all() {
        Fan out;
        out.state_ = State::wide;
        return out;
    }
    void include(const Vec2& direction);
    void include(const Fan& other);

    bool is_empty() const { return state_ == State::empty; }
    /// No half plane holds all of them with some room to spare: 20 degrees.
    bool is_wide() const { return state_ == State::wide; }
    const Vec2& first() const { return first_; }  ///< unit; meant where it is neither empty nor wide
    const Vec2& last() const { return last_; }    ///< counter-clockwise of it

private:
    void check();

    enum class State : unsigned char { empty, narrow, wide } state_ = State::empty;
    Vec2 first_{1, 0}, last_{1, 0};
};

/// Finds the fans of an op's tree. Where all the surfaces that can matter in a disc face ways that one half plane holds, so do all fields made
/// of theirs by min, max and their smooth kin: along that half plane's axis the field only rises, and its zero line is a graph over the
/// other axis. No part of it can then hide between places that were looked at.
class FanFinder {
public:
    explicit FanFinder(const Field& field) : field_(field) {}

    /// Of the field in the disc about p.
    Fan fan(int op, const Vec2& p, double radius) { return near(op, p, radius).fan; }

private:
    /// What is known in a disc: the value in its middle, and how much it may change from there.
    struct Near {
        double value = 0, change = 0;
        Vec2 gradient{0, 0};
        Fan fan;
    };
    Near near(int index, const Vec2& p, double radius);
    Near near_shape(int index, const Vec2& p, double radius);
    Fan fan_over_square(const Op& op, const Vec2& p, double radius) const;
    Near near_fold(const Op& op, const Vec2& p, double radius);
    Near near_modify(const Op& op, const Vec2& p, double radius);
    Near near_images(const Op& op, const Vec2& p, double radius);
    Near near_warp(const Op& op, const Vec2& p, double radius);
    bool warps_smoothly(const Op& op, const Vec2& local, const Vec2& half, std::vector<sdf::Warped>& seen) const;
    const sdf::Outline& outline_of(int index);

    const Field& field_;
    std::map<int, sdf::Outline> outlines_;  ///< of shapes, in their own frames
};

}  // namespace pinfield
