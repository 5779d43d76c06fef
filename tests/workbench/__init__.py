"""Pages in a browser, which the tests of this package share."""
