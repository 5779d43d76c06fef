/* A comment without end. */
int main(void) { return 0; }
/* // error: comment
