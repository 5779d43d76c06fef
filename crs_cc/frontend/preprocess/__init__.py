"""The C preprocessor: directives, macros and includes, with a map back to the user's lines."""
