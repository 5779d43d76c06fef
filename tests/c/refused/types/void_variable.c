/* A variable of type void. */
int main(void)
{
    void nothing; // error: void
    return 0;
}
