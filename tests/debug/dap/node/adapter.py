"""Serves an editor on the standard streams: what the public test client starts."""

import sys

from crs_cc.cli.main import main

if __name__ == "__main__":
    sys.exit(main(["debug", "--dap", "stdio"]))
