"""The parts of the C preprocessor; `crs_cc.frontend.preprocess` puts them together."""
