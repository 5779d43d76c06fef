/* A condition on a variable that was never set. */
int main(void)
{
    int done;

    if (done) // error: uninitialised read
        return 1;
    return 0;
}
