"""`python -m crs_cc` is `crs`."""

from crs_cc.cli.process import start

if __name__ == "__main__":
    start()
