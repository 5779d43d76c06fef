"""Serves an editor on the standard streams: what the public test client starts."""

import sys

from crs_cc.cli.main import main

sys.exit(main(["debug", "--dap", "stdio"]))
