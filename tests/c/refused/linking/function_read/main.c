/* What one file reads is a function in the other. */
extern int turn;
int main(void) { return turn; }  // error: 'turn' is used as a variable, but it is a function
