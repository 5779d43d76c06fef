int limit = 20;
int speed(void) { return 2; }
