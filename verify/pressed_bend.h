/// \file
/// A bend that is pressed flat between plates, and the fold that it keeps.
#pragma once

#include <shell_origami/energy/material.h>

namespace shell_origami {

/// The angle [rad] that paper keeps in a bend of half a turn which plates have pressed from a wide
/// loop, nowhere bent beyond yield, to a gap [m], from middle to middle of the paper.
///
/// Between plates a gap H apart the elastica has kappa = (I / H) sqrt(sin psi), where psi is its
/// angle to the plates and I the integral of sqrt(sin psi) over the half turn. Seen from the apex
/// it is kappa = (I / H) g(s / H), the same curve at every H. As the plates close, paper at s is
/// bent most when s = u* H, with g + u g' = 0 at u*, to C / s with C = I u* g(u*); nearer to the
/// apex it is bent most at last. Of the largest curvature (kappa - kappa_y) / (1 + h) stays:
///
///   kept = 2 / (1 + h) (A - C + C ln(C / (u* kappa_y H)))
///
/// with the turn A = pi / 2 - psi* from the apex to u*. What yields changes the curve a little,
/// which the formula leaves out.
double keptOfPressedBend(double gap, const Material& material);

/// The same angle [rad] of a strip that is bent over by its end, pressed between a table and a
/// plate, and let go. \throws std::runtime_error where it does not get there
double simulatedPressedBend(double gap, const Material& material, double max_edge);

}  // namespace shell_origami
