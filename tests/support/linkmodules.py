"""The client of the live link and the bridge for Maya as tests of the source tree import them, with a stand-in for Maya."""

import os
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path[:0] = [os.path.join(ROOT, "python", "autocuts"), os.path.join(ROOT, "integrations", "maya")]
import link
import mayastandin

mayastandin.install()
import autocuts_maya
