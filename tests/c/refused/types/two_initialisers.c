/* Two definitions with initialisers. */
int speed = 1;
int speed = 2; // error: redefinition

int main(void)
{
    return speed;
}
