"""World files and robot definitions: from XML and pictures to the models."""
