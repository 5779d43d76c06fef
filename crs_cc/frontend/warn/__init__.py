"""Warnings about code that is valid C but probably not what its author meant."""
