/// \file
/// One term of the objective that a step minimizes.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/linear/block_matrix.h>

#include <memory>
#include <optional>

namespace shell_origami {

/// The reason why a configuration is infeasible.
struct Infeasibility {
  const char* what;
  int vertex;  ///< where; -1: everywhere
};

enum class HessianKind {
  kConvex,  ///< positive semidefinite: terms that make the energy concave are left out
  kExact    ///< exact, or so close to it that Newton's method converges as fast
};

/// An energy of the vertices' positions. dynamics/ minimizes the sum of several: the shell's and
/// those that a program adds. It is const: data of a configuration are in an Iterate, of which the
/// solver owns as many as it compares. Calls are virtual for each potential, not for each
/// element.
///
/// It is a step filter as well: a configuration is reached from another one only if every potential
/// permits it (maxFeasibleStep() for a step of Newton's method, findInfeasibility() for any other:
/// the start of a step, held vertices, an edit).
class Potential {
 public:
  /// Data of a potential that belong to one configuration, such as fold angles or pairs in contact.
  class Iterate {
   public:
    virtual ~Iterate() = default;
  };

  virtual ~Potential() = default;

  virtual std::unique_ptr<Iterate> makeIterate() const = 0;

  /// Fills `at` for a configuration x from which others are reached. \pre x is feasible
  virtual void start(const Positions& x, Iterate& at) const = 0;
  /// Returns the energy [J] at x and fills `at`. Infinite, and `at` unspecified, where x is
  /// infeasible or cannot be reached from the configuration of `from`.
  virtual double value(const Positions& x, const Iterate& from, Iterate& at) const = 0;
  /// Returns the reason if value() is infinite.
  virtual std::optional<Infeasibility> findInfeasibility(const Positions& x,
                                                         const Iterate& from) const = 0;

  /// Adds dW/dx [N] at the configuration of `at`, and completes `at` for addHessian() and
  /// maxFeasibleStep().
  virtual void addGradient(const Positions& x, Iterate& at, Positions& gradient) const = 0;
  /// The stencils of addHessian(), which may differ from iterate to iterate.
  virtual const Stencils& stencils(const Iterate& at) const = 0;
  virtual void addHessian(const Positions& x, const Iterate& at, HessianKind kind,
                          HessianBlocks& blocks) const = 0;
  /// Returns the largest part of `step` in [0, 1] that Newton's method may take from x.
  virtual double maxFeasibleStep(const Positions& x, Iterate& at, const Positions& step) const = 0;
  /// Looks for what a whole `step` from x would run into, and adds to the Hessian and, by
  /// addAnticipated(), to the gradient a spring for each of these, which stops the next step there.
  /// It is no part of the energy. Returns whether there is any; the next addGradient() forgets
  /// them.
  virtual bool anticipate(const Positions& /*x*/, Iterate& /*at*/,
                          const Positions& /*step*/) const {
    return false;
  }
  virtual void addAnticipated(const Positions& /*x*/, const Iterate& /*at*/,
                              Positions& /*gradient*/) const {}
  /// Moves vertices of x, where a step is to start, towards `before`, where it came from and that
  /// `at` is of, until x can be reached. What it leaves infeasible is found by value().
  virtual void filterStart(const Positions& /*before*/, Iterate& /*at*/, Positions& /*x*/) const {}
  /// Whether forces at the iterate may jump within a step, as where paper touches. The next step
  /// then does not assume that accelerations persist.
  virtual bool rough(const Iterate& /*at*/) const { return false; }
  /// Stores in `at`, the iterate at x + displacement, changes to first order from x, by the
  /// derivatives at `along`, that make the Hessian better than the exact ones do (the membrane's
  /// stress).
  virtual void predict(const Positions& /*x*/, const Positions& /*along*/,
                       const Positions& /*displacement*/, Iterate& /*at*/) const {}
  /// Changes the gradient at x for a step by the Hessian at `along`: forces that predict() did not
  /// foresee, of what is stiff in some directions and soft in others (the membrane), are given the
  /// directions that they have at `along`.
  virtual void redirect(const Positions& /*x*/, const Iterate& /*at*/, const Positions& /*along*/,
                        Positions& /*gradient*/) const {}
  /// Returns a place at which a whole step went further than one step may.
  virtual std::optional<Infeasibility> findJump(const Iterate& /*from*/,
                                                const Iterate& /*to*/) const {
    return std::nullopt;
  }
};

}  // namespace shell_origami
