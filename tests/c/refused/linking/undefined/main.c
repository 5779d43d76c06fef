extern int turn(int);
extern int speed;
int main(void)
{
    return turn(1) + speed;  // error: 'speed' is used, but not defined
//                   ^
}
