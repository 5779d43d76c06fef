/* Names do not begin with digits. */
int main(void)
{
    int 3rd = 3; // error: 'rd' cannot end the number 3
    return 0;
}
