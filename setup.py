"""For catkin: the Python module."""

from setuptools import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=['shell_origami'], package_dir={'': 'python'}))
