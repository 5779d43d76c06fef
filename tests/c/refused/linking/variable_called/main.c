/* What one file calls is a variable in the other. */
int turn(void);
int main(void) { return turn(); }  // error: 'turn' is called as a function, but it is a variable
