"""The viewer of runs: ES modules for a browser, and the page that holds a recorded run."""
