"""Functions of the scripts that take rviz's picture: an rviz on a display of its own. Programs started
here end with the `with` block that they run in."""
import contextlib
import os
import re
import signal
import subprocess
import sys
import threading

from rviz_config import Failure, config_for, write_config

# Debian 11's rospy calls this method at its end, which Debian 11's Python no longer has.
if not hasattr(threading.Thread, "isAlive"):
    threading.Thread.isAlive = threading.Thread.is_alive

# Pictures are drawn this many times as large and then reduced, for smooth edges.
OVERSAMPLING = 2


def read_size(text):
    """Parses WIDTHxHEIGHT in pixels, as a type of argparse."""
    size = re.fullmatch(r"([1-9]\d{1,3})x([1-9]\d{1,3})", text)
    if not size:
        raise ValueError
    return int(size[1]), int(size[2])


read_size.__name__ = "size, WIDTHxHEIGHT in pixels"  # as argparse calls it in its errors


def bare_config(view, box, width, height):
    """rviz's configuration with a recipe's view of the box, no panels."""
    config = config_for(view, box)
    config["Panels"] = []
    config["Visualization Manager"]["Tools"] = [{"Class": "rviz/MoveCamera"}]
    config["Window Geometry"] = {"X": 0, "Y": 0, "Width": width, "Height": height,
                                 "Hide Left Dock": True, "Hide Right Dock": True}
    return config


@contextlib.contextmanager
def running(command, **options):
    """Runs a program during the `with` block, in a process group of its own: Ctrl-C does not reach it."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, start_new_session=True, **options)
    try:
        yield process
    finally:
        stop(process, signal.SIGTERM)


def stop(process, how):
    """Ends a program and the processes that it started."""
    for attempt in (how, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, attempt)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(5)
            return


@contextlib.contextmanager
def virtual_display(width, height):
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "%dx%dx24" % (width, height)]
    with running(command, pass_fds=[writing], stderr=subprocess.DEVNULL):
        os.close(writing)
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Failure("Xvfb does not start")
        yield ":" + number


class Rviz:
    """An rviz that fills its display. Its output is printed if the block fails."""

    def __init__(self, process, environment):
        self.process = process
        self.environment = environment

    def screenshot(self, *options):
        """Returns the display as ImageMagick's `import` captures it, with its options and image format."""
        if self.process.poll() is not None:
            raise Failure("rviz ended with status %d" % self.process.returncode)
        return subprocess.run(["import", "-silent", "-window", "root", *options],
                              env=self.environment, check=True, stdout=subprocess.PIPE).stdout


@contextlib.contextmanager
def offscreen_rviz(config, folder):
    path = os.path.join(folder, "offscreen.rviz")
    write_config(path, config)
    window = config["Window Geometry"]
    with virtual_display(window["Width"], window["Height"]) as display, \
            open(os.path.join(folder, "rviz.log"), "w+") as log:
        # A home of its own, so that the user's rviz settings are neither read nor written.
        environment = dict(os.environ, DISPLAY=display, HOME=folder, XDG_RUNTIME_DIR=folder,
                           LIBGL_ALWAYS_SOFTWARE="1", QT_X11_NO_MITSHM="1")
        command = ["rviz", "--fullscreen", "--display-config", path]
        with running(command, env=environment, stdout=log, stderr=log) as rviz:
            try:
                yield Rviz(rviz, environment)
            except Failure:
                log.seek(0)
                sys.stderr.write(log.read())
                raise


def exit_code_of(work, name):
    """Runs a script's main function; an error becomes one line and a non-zero exit code."""
    # The programs started here end with this one.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        work()
    except (Failure, OSError) as error:
        return "%s: %s" % (name, error)
    except subprocess.CalledProcessError as error:
        return "%s: %s fails with status %d" % (name, error.cmd[0], error.returncode)
    except KeyboardInterrupt:
        return 130
    return 0
