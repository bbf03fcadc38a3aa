"""The steps of a recipe in words, and the places on the paper that they name."""
import math

import yaml

from diagram_paper import cross2, sub

# Folds by less than this only mark creases; by more they are shut [deg].
MARK, SHUT = 5, 170
NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"]


def number(count):
    return NUMBERS[count] if count < len(NUMBERS) else str(count)


def listed(words):
    return " and ".join(filter(None, [", ".join(words[:-1])] + words[-1:]))


class Loader(yaml.SafeLoader):
    """Reads `on` as a word: YAML 1.1 takes it for true."""


Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers if tag != "tag:yaml.org,2002:bool"]
    for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()}


class Places:
    """The landmarks of a recipe: where they are on the flat sheet, and what they are called. Those without
    a name are called by letters, from A on in each picture."""

    def __init__(self, recipe, corners):
        self.names = recipe.get("names") or {}
        self.corners = corners
        self.begin()

    def begin(self):
        self.marks = {}  # of this picture: the places by what they are called

    def is_landmark(self, value):
        if isinstance(value, dict):
            return bool({"corner", "on", "meet"} & set(value))
        if isinstance(value, list):
            return len(value) == 2 and all(isinstance(number, (int, float)) for number in value)
        return isinstance(value, str) and value in self.names

    def flat(self, place):
        """Returns the landmark's place on the flat sheet."""
        if isinstance(place, str):
            return self.flat(self.names[place])
        if isinstance(place, list):
            return tuple(place)
        if "corner" in place:
            return min(self.corners, key=lambda corner: math.dist(corner, place["corner"]))
        if "on" in place:
            a, b = map(self.flat, place["on"])
            part = place.get("at", 0.5)
            return tuple((1 - part) * x + part * y for x, y in zip(a, b))
        a, b, c, d = map(self.flat, place["meet"])
        way, other = sub(b, a), sub(d, c)
        part = cross2(sub(c, a), other) / cross2(way, other)
        return tuple(x + part * y for x, y in zip(a, way))

    def call(self, place):
        """Returns what a caption calls a landmark, which is marked in the picture."""
        at = self.flat(place)
        if isinstance(place, str):
            self.marks[place.replace("_", " ")] = at
            return "the " + place.replace("_", " ")
        for name, other in self.marks.items():
            if math.dist(other, at) < 1e-9:
                return name
        letter = chr(ord("A") + sum(len(name) == 1 for name in self.marks))
        self.marks[letter] = at
        return letter


class Words:
    """The caption of a step, and which point of the flat sheet an arrow begins at (None: any)."""

    def __init__(self, caption, moves=None):
        self.caption, self.moves = caption, moves


def fold_through(fold, places):
    call, behind = places.call, fold.get("way") == "behind"
    away = " behind" if behind else ""
    moves = None
    if "bring" in fold:
        caption = "Bring %s%s to %s." % (call(fold["bring"]), away, call(fold["to"]))
        moves = fold["bring"]
    elif "edge" in fold:
        caption = "Bring the edge from %s to %s%s onto that from %s to %s." % (
            *map(call, fold["edge"]), away, *map(call, fold["to_edge"]))
        moves = {"on": fold["edge"]}
    elif "across" in fold:
        caption = "Fold %s%s along the line through %s, at a right angle to the edge from %s to %s." % (
            call(fold["move"]), away, call(fold["at"]), *map(call, fold["across"]))
        moves = fold["move"]
    else:
        caption = "Fold %s%s along the line from %s to %s." % (
            call(fold["move"]), away or " over", *map(call, fold["through"]))
        moves = fold["move"]
    return Words(caption + layer_words(fold, call) + angle_words([fold.get("angle_deg", 178)]),
                 places.flat(moves))


def layer_words(fold, call):
    layers = fold.get("layers", "all")
    if "flap" in fold:
        return " Take only the flap at %s." % call(fold["flap"])
    if layers == "all":
        return ""
    count = layers["top"]
    return " Take only the top layer." if count == 1 else " Take the top %s layers." % number(count)


def fold_line(fold, places):
    """Where the line of a fold is, told by one of the axioms."""
    call = places.call
    if "bring" in fold:
        return "the line that brings %s to %s" % (call(fold["bring"]), call(fold["to"]))
    if "edge" in fold:
        return "the line that brings the edge from %s to %s onto that from %s to %s" % (
            *map(call, fold["edge"]), *map(call, fold["to_edge"]))
    if "across" in fold:
        return "the line through %s, at a right angle to the edge from %s to %s" % (
            call(fold["at"]), *map(call, fold["across"]))
    return "the line from %s to %s" % tuple(map(call, fold["through"]))


def petal(entry, places):
    return Words("Petal fold: lift the tip at %s, and bring the edges beside it together."
                 % places.call(entry["flap"]), places.flat(entry["flap"]))


def squash(entry, places):
    call = places.call
    return Words("Squash fold: raise the flap at %s, open it, and flatten it so that %s comes onto the line "
                 "from %s to %s." % (call(entry["flap"]), call(entry["bring"]), *map(call, entry["to"])),
                 places.flat(entry["bring"]))


def reverse(entry, places):
    kind, way = ("Inside", "into") if entry.get("inside", True) else ("Outside", "around")
    return Words("%s reverse fold: turn the tip at %s inside out, %s the paper, along %s."
                 % (kind, places.call(entry["flap"]), way, fold_line(entry, places)),
                 places.flat(entry["flap"]))


def pleat(entry, places):
    away = " behind" if entry.get("way") == "behind" else ""
    return Words("Pleat: fold%s along %s, and back along the line from %s to %s.%s"
                 % (away, fold_line(entry, places), *map(places.call, entry["back"]),
                    layer_words(entry, places.call)))


def rabbit_ear(entry, places):
    call, (near, far) = places.call, entry["base"]
    return Words("Rabbit ear: bring both edges at %s onto the line from %s to %s; the tip comes to point to %s."
                 % (call(entry["flap"]), call(near), call(far), call(far)), places.flat(entry["flap"]))


def unfold(*_):
    return Words("Unfold the last step.")


def angle_words(angles):
    open_angles = sorted({round(abs(angle)) for angle in angles if MARK <= abs(angle) < SHUT})
    return " Turn it by %s degrees." % listed([str(angle) for angle in open_angles]) if open_angles else ""


def fold(entries, _):
    """Plain folds along lines and of creases."""
    angles = [entry["angle_deg"] for entry in entries if "angle_deg" in entry]
    names = list(dict.fromkeys(entry.get("crease") or entry.get("name") for entry in entries))
    called = listed([name.replace("_", " ") for name in names if name])
    if called in ("all", "mountains", "valleys"):
        lines = "all %s of the pattern" % ("lines" if called == "all" else called)
    elif all("crease" in entry for entry in entries) and len(names) < 5:
        lines = "the crease%s %s" % ("s" if len(names) > 1 else "", called)
    else:
        lines = "the line" if len(entries) == 1 else "the %s lines" % number(len(entries))
        if called and len(names) < 5:
            lines += " (%s)" % called
    if len(angles) == len(entries) and all(abs(angle) < MARK for angle in angles):
        return Words("Crease along %s." % lines)
    away = " behind" if angles and all(angle < 0 for angle in angles) else ""
    return Words("Fold%s along %s%s.%s" % (away, lines, " together" if len(entries) > 1 else "",
                                          angle_words(angles)))


def other_step(word, entry, places):
    """A step that has no words of its own: its word, and the landmarks that it names."""
    called = []
    for key, value in entry.items() if isinstance(entry, dict) else []:
        landmarks = [value] if places.is_landmark(value) else value
        if isinstance(landmarks, list) and all(map(places.is_landmark, landmarks)):
            called.append("%s %s" % (key.replace("_", " "), listed(list(map(places.call, landmarks)))))
    return Words(word.replace("_", " ").capitalize() + (": " + ", ".join(called) if called else "") + ".")


class Recipe:
    """A recipe's file as the diagram reads it."""

    WORDS = {"fold_through": fold_through, "fold": fold, "petal": petal, "squash": squash, "reverse": reverse,
             "pleat": pleat, "rabbit_ear": rabbit_ear, "unfold": unfold}

    def __init__(self, path, corners):
        with open(path, encoding="utf-8") as file:
            self.recipe = yaml.load(file, Loader)
        self.steps = self.recipe["steps"]
        self.places = Places(self.recipe, corners)

    def words(self, step):
        """Returns the words of a step, the first of which is 1."""
        self.places.begin()
        entries = {word: entry for word, entry in self.steps[step - 1].items() if word != "duration"}
        word, entry = next(iter(entries.items()))
        if word in self.WORDS:
            return self.WORDS[word](entry, self.places)
        return other_step(word, entry, self.places)

    def turns_over(self, after, before):
        """Returns whether the paper is turned over between two steps; before 0: until the end."""
        steps = self.steps[after:before - 1 if before else None]
        return sum("turn_over" in step for step in steps) % 2 == 1

    def view(self):
        """Returns yaw and pitch of the camera [rad], or None."""
        view = self.recipe.get("view")
        return view and (math.radians(view.get("yaw_deg", 45)), math.radians(view.get("pitch_deg", 40)))


class Titles:
    """What a sequence without a recipe says of its steps."""

    def __init__(self, papers):
        self.titles = {paper.step: paper.title for paper in papers}
        self.places = Places({}, [])

    def words(self, step):
        return Words(self.titles[step].replace("_", " ").capitalize() + ".")

    def turns_over(self, *_):
        return False

    def view(self):
        return None
