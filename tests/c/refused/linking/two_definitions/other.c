int speed = 4;  // error: multiple definition of 'speed'
//  ^
int turn(void) { return 2; }  // error: multiple definition of 'turn'
