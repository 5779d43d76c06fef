int main;  // error: 'main' is called as a function, but it is a variable
