"""Kernels for words of tables, in C that crs compiles itself; see `crs_cc.net.changed_words`."""
