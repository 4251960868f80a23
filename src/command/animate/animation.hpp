// SPDX-License-Identifier: GPL-2.0-or-later
// A scene's motion as a page that plays it, and as a moving picture.
#pragma once

#include <string>

#include "command/scene_motion.hpp"

namespace magicmass::command {

/// One HTML file, with no network: bodies on a line, driven by keyboard or buttons. Paused at first; where the system asks
/// for reduced motion, playing goes from collision to collision.
std::string animation_page(const std::string& title, const SceneMotion& motion);

/// An animated GIF of the same, drawn by gnuplot: 200 pictures of at most the first three crossing times. Throws
/// as drawn() does.
std::string animation_gif(const SceneMotion& motion);

/// What plays the motion in animation_page, and how it looks.
extern const char* const animation_player;
extern const char* const animation_style;

}  // namespace magicmass::command
