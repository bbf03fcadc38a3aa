#!/usr/bin/python3
"""An environment of Gymnasium's shape, without a dependency on it: fold a square so that one of its corners
comes to a goal in space, by at most three straight folds. Run by itself, it folds at random.

    env = FoldEnv()
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(action)

An action is five numbers from -1 to 1: two points of a line on the flat sheet, and the fold's angle over its
largest. An observation is the places of the corners and of the goal [m]. The reward of a fold is by how much
nearer it brings the corner to the goal [m]; a fold that the paper rejects costs a millimetre. Same seed and
actions, same observations, to the bit."""

import math

import numpy as np

from shell_origami import core

SIDE = 0.1                      # [m]
LARGEST = math.radians(170)     # of a fold
MOST_FOLDS = 3
NEAR = 0.005                    # [m] of the goal
FOLD_DURATION, REST = 0.5, 0.5  # [s]
REJECTED = -0.001


class FoldEnv(object):
    def __init__(self):
        self.random = np.random.default_rng()

    def reset(self, seed=None, options=None):
        """Returns the first observation of a new flat sheet and a new goal."""
        del options
        if seed is not None:
            self.random = np.random.default_rng(seed)
        self.paper = core.Simulation(SIDE, SIDE, 0.025)
        corners = [(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)]
        self.corners = [self.vertex_at(*corner) for corner in corners]
        center = self.vertex_at(SIDE / 2, SIDE / 2)
        self.paper.pin(vertices=[center])
        self.goal = self.random.uniform((0, 0, 0), (SIDE, SIDE, SIDE / 2))
        self.folds = 0
        return self.observation(), {}

    def step(self, action):
        action = np.clip(np.asarray(action, dtype=float), -1, 1)
        before = self.distance()
        line = (action[:4].reshape(2, 2) + 1) / 2 * SIDE
        self.folds += 1
        try:
            self.paper.fold(line=line.tolist(), angle=action[4] * LARGEST, duration=FOLD_DURATION)
            self.paper.step(round((FOLD_DURATION + REST) / self.paper.time_step))
            reward, why = before - self.distance(), ''
        except (ValueError, core.SimulationError) as error:
            reward, why = REJECTED, str(error)
        terminated = bool(self.distance() < NEAR)
        return (self.observation(), reward, terminated, not terminated and self.folds >= MOST_FOLDS,
                {'rejected': why})

    def vertex_at(self, x, y):
        return int(np.argmin(np.linalg.norm(self.paper.flat_positions - (x, y), axis=1)))

    def distance(self):
        """How far the first corner is from the goal [m]."""
        return float(np.linalg.norm(self.paper.positions[self.corners[0]] - self.goal))

    def observation(self):
        return np.concatenate([self.paper.positions[self.corners].ravel(), self.goal])


def main():
    env = FoldEnv()
    actions = np.random.default_rng(0)
    for seed in range(5):
        env.reset(seed=seed)
        total, done = 0.0, False
        while not done:
            _, reward, terminated, truncated, _ = env.step(actions.uniform(-1, 1, 5))
            total += reward
            done = terminated or truncated
        print('goal %d: %+.1f mm nearer after %d folds' % (seed, 1000 * total, env.folds))


if __name__ == '__main__':
    main()
