int speed = 3;
int turn(void) { return 1; }
int main(void) { return turn() + speed; }
