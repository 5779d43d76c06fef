"""From IR to WebAssembly: `module` makes a program's code, `function_code` that of one function."""
