/* Two members of one name. */
struct point { int x; double x; }; // error: duplicate

int main(void)
{
    return 0;
}
