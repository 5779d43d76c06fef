"""Readers of world files and robot definitions: from XML and images to models."""
