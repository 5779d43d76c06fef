"""Semantic analysis: from pycparser's tree to the checked tree, every type spelled out."""
