int turn(void) { return 1; }
int main(void) { return turn(); }
