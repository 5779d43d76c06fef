static int speed = 3;
int turn_left(int n) { return n + speed; }
int turn(int n)
{
    return turn_lefty(n);  // error: did you mean 'turn_left'?
//         ^
}
