int limit = 20;
int speed(void) { return 2; }
int turn(void) { return 7; }
int back(void) { return 8; }
int aside(void);
int named_elsewhere(void) { return aside(); }
