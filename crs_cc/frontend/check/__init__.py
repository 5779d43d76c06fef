"""Semantic analysis: from pycparser's tree to the checked tree, in which all types are explicit."""
